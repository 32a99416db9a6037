// See cases.h.
#include "stress/cases.h"

#include <array>
#include <exception>

#include "runtime/loading/data_folders.h"
#include "runtime/loading/graph_loading.h"
#include "stress/axes.h"
#include "stress/cpu.h"
#include "stress/laws.h"
#include "stress/media.h"
#include "text/diagnostics.h"

namespace nephrite::stress {
namespace {

/// The best graph for every scene, the others by turns, so that the list stays short.
std::vector<GraphChoice> graphsFor(std::size_t number) {
    std::vector<GraphChoice> graphs{graphNamed("consistent")};
    if (number % 2 == 0) graphs.push_back(graphNamed("paper"));
    if (number % 5 == 1) graphs.push_back(graphNamed("light-pyramid"));
    if (number % 5 == 3) graphs.push_back(graphNamed("screen-space"));
    return graphs;
}

void addDeviceCases(const Place& place, std::vector<Case>& cases) {
    std::size_t number = 0;
    for (const auto& scenes : {singleScenes(), pairScenes()}) {
        for (const NamedScene& named : scenes) {
            const std::vector<GraphChoice> graphs = graphsFor(number++);
            cases.push_back({"device/" + named.name, [named, graphs, place](Outcome& outcome) {
                                 checkOnDevice(named.scene, graphs, place, outcome);
                             }});
        }
    }
}

/// A mesh with a vertex that is not a number is refused, not rendered.
void checkRefused(const SceneValues& scene, const Place& place, Outcome& outcome) {
    bool refused = false;
    try {
        runtime::loadScene(write(scene, place.folder), 0, runtime::DataFolders::find());
    } catch (const InputError&) {
        refused = true;
    }
    outcome.check(refused, "the scene was not refused");
}

void addRefusedCases(const Place& place, std::vector<Case>& cases) {
    SceneValues scene;
    scene.objects.front().shape = Shape::notANumber;
    cases.push_back(
        {"refused/not-a-number", [scene, place](Outcome& outcome) { checkRefused(scene, place, outcome); }});
}

void addMediumCases(std::vector<Case>& cases) {
    std::size_t number = 0;
    for (const NamedMedium& named : media()) {
        const bool withBurley = number++ % 16 == 0;
        cases.push_back({"profile/" + named.name, [named, withBurley](Outcome& outcome) {
                             checkProfiles(named.medium, outcome);
                             if (withBurley) checkBurley(named.medium, outcome);
                         }});
    }
    for (const NamedStack& named : stacks())
        cases.push_back(
            {"photons/" + named.name, [named](Outcome& outcome) { checkPhotons(named.stack, outcome); }});
}

/// Volumes in which light is scattered ten thousand times a millimetre take hours: the references leave them
/// out.
bool isTraceable(const SceneValues& scene) {
    for (const MaterialValues& material : scene.materials)
        for (const LayerValues& layer : material.layers)
            for (const double scattering : layer.scattering)
                if (scattering > 100) return false;
    return true;
}

void addReferenceCases(const Place& place, std::vector<Case>& cases) {
    for (const NamedScene& named : singleScenes())
        if (isTraceable(named.scene))
            cases.push_back({"reference/" + named.name, [named, place](Outcome& outcome) {
                                 checkReferences(named.scene, place, outcome);
                             }});
}

}  // namespace

std::vector<Case> allCases(const Place& place) {
    std::vector<Case> cases;
    addDeviceCases(place, cases);
    addRefusedCases(place, cases);
    for (Case& law : lawCases(place)) cases.push_back(std::move(law));
    addMediumCases(cases);
    addReferenceCases(place, cases);
    return cases;
}

Outcome run(const Case& item) {
    Outcome outcome{item.name, 0, {}};
    try {
        item.run(outcome);
    } catch (const std::exception& error) {
        outcome.check(false, error.what());
    }
    return outcome;
}

}  // namespace nephrite::stress
