// See device.h.
#include "stress/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "graph/format.h"
#include "graph/modifiers.h"
#include "runtime/loading/data_folders.h"
#include "runtime/loading/graph_loading.h"
#include "runtime/session.h"

namespace nephrite::stress {
namespace {

/// Every output of every node whose values are light or geometry, as "node.port": no depth buffers, no
/// integers, nothing that another node overwrites within the frame.
std::vector<std::string> portsOf(const graph::LinkedGraph& graph) {
    const std::vector<graph::Modifier> modifiers = graph::findModifiers(graph);
    std::vector<std::string> ports;
    for (graph::Index node = 0; node < graph.nodes.size(); ++node) {
        const graph::LinkedNode& linked = graph.nodes[node];
        if (linked.role != graph::NodeRole::Pass) continue;
        for (graph::Index port = 0; port < linked.type->outputs.size(); ++port) {
            const graph::FormatInfo& format = graph::info(linked.type->outputs[port].format);
            const bool lasts = modifiers[linked.formats.first + port].node == graph::noIndex;
            if (lasts && !format.isDepth && !format.isUnsignedInteger)
                ports.push_back(graph.portName(node, port));
        }
    }
    return ports;
}

/// Whether a channel of port "node.port" is an amount of light, which is never negative. A flux lies beside
/// the position it enters at.
bool isLight(const std::string& name, const std::string& channel) {
    const std::string port = name.substr(name.find('.') + 1);
    const bool isAlpha = channel.back() == 'A';
    if (port == "flux") return isAlpha;
    return !isAlpha && (port == "radiance" || port == "color" || port == "irradiance");
}

void checkImage(const image::Image& image, const std::string& name, Outcome& outcome) {
    std::size_t infinite = 0;
    std::size_t negative = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float value = image.pixels[i];
        if (!std::isfinite(value)) ++infinite;
        if (value < 0 && isLight(name, image.channels[i % image.channels.size()])) ++negative;
    }
    outcome.check(infinite == 0,
                  fmt::format("{}: {} of {} values are not finite", name, infinite, image.pixels.size()));
    outcome.check(negative == 0,
                  fmt::format("{}: {} of {} values are negative", name, negative, image.pixels.size()));
}

double length(const Triple& a, const Triple& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// An upper bound of the radiant intensity, W/sr, that scattering objects send towards a camera. What enters
/// is at most each light's intensity times the solid angle of a sphere around the object (all directions from
/// inside it). Spread over a hemisphere by a matt surface, Phi gives at most Phi/pi in one direction;
/// scattered light leaves nearly so, but coarse pixels sample its peaks unevenly, hence the factor. It is
/// meant to catch what explodes, not what is a little too bright.
double radiatedBound(const SceneValues& scene) {
    constexpr double factor = 4;
    double entering = 0;
    for (const LightValues& light : scene.lights) {
        for (const ObjectValues& object : scene.objects) {
            const double sine = objectRadius / length(light.position, object.place);
            const double share = sine < 1 ? sine * sine / (2 * (1 + std::sqrt(1 - sine * sine))) : 1;
            entering += light.intensity * scene.scale * scene.scale * 4 * std::numbers::pi * share;
        }
    }
    return factor * entering / std::numbers::pi;
}

/// Whether the bound is one of the picture: no mirror, which gathers light in few directions, no environment,
/// and a camera that is outside.
bool isBounded(const SceneValues& scene) {
    if (scene.environment != 0) return false;
    for (const MaterialValues& material : scene.materials)
        if (material.specular) return false;
    return std::all_of(scene.objects.begin(), scene.objects.end(), [&](const ObjectValues& object) {
        return length(scene.camera, object.place) > 1.5 * objectRadius;
    });
}

/// The integral of radiance times projected area over what the picture shows, W/sr, by channel.
Triple radiated(const image::Image& color, const image::Image& position, const SceneValues& scene) {
    Triple sum{};
    const std::uint32_t size = color.width;
    const double slope = std::tan(scene.fovY * std::numbers::pi / 360);
    for (std::uint32_t y = 0; y < size; ++y) {
        for (std::uint32_t x = 0; x < size; ++x) {
            if (position.at(x, y, 3) == 0) continue;
            const Triple seen{position.at(x, y, 0) / scene.scale, position.at(x, y, 1) / scene.scale,
                              position.at(x, y, 2) / scene.scale};
            const double right = (2 * (x + 0.5) / size - 1) * slope;
            const double up = (1 - 2 * (y + 0.5) / size) * slope;
            const double cosine = 1 / std::sqrt(1 + right * right + up * up);
            const double distance = length(seen, scene.camera) * scene.scale;
            const double area =
                std::pow(2 * slope / size, 2) * cosine * cosine * cosine * distance * distance;
            for (std::uint32_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(color.at(x, y, c)) * area;
        }
    }
    return sum;
}

void checkFrame(runtime::Session& session, const GraphChoice& choice, const std::vector<std::string>& ports,
                const SceneValues& scene, Outcome& outcome) {
    session.renderFrame(0);
    const std::string graph = choice.file.stem().string();
    for (const std::string& port : ports) checkImage(session.read(port), graph + ": " + port, outcome);
    const image::Image color = session.read("color");
    checkImage(color, graph + ": color", outcome);
    if (!choice.conserving || !isBounded(scene)) return;
    const Triple sent = radiated(color, session.read("gbuffer.position"), scene);
    const double bound = radiatedBound(scene);
    for (const double channel : sent)
        outcome.check(channel <= bound * (1 + 1e-6),
                      fmt::format("{}: {:.3g} W/sr towards the camera, bound {:.3g}", graph, channel, bound));
}

runtime::SessionOptions optionsFor(const SceneValues& scene, const GraphChoice& graph, const Place& place,
                                   std::uint32_t size) {
    runtime::SessionOptions options;
    options.scene = write(scene, place.folder);
    options.graph = graph.file;
    options.settings = graph.settings;
    options.size = {size, size};
    options.device = place.device;
    options.passPaths = place.passPaths;
    return options;
}

}  // namespace

GraphChoice graphNamed(const std::string& name) {
    GraphChoice choice;
    choice.file = runtime::DataFolders::find().materials.parent_path() / (name + ".json");
    choice.settings = {"lightSize=64"};
    if (name == "consistent" || name == "light-pyramid") choice.settings.emplace_back("treeSize=32");
    choice.conserving = name != "paper";
    return choice;
}

void checkOnDevice(const SceneValues& scene, const std::vector<GraphChoice>& graphs, const Place& place,
                   Outcome& outcome) {
    const auto folders = runtime::DataFolders::find();
    std::optional<runtime::Session> session;
    for (const GraphChoice& graph : graphs) {
        const auto loaded = runtime::loadGraph(graph.file, graph.settings, folders, place.passPaths);
        const std::vector<std::string> ports = portsOf(*loaded.graph);
        if (session) {
            session->setGraph({graph.file, graph.settings, ports});
        } else {
            runtime::SessionOptions options = optionsFor(scene, graph, place, stressedSize);
            options.dumps = ports;
            session.emplace(options);
        }
        checkFrame(*session, graph, ports, scene, outcome);
    }
}

std::vector<Triple> pictureMeans(const SceneValues& scene, const std::vector<GraphChoice>& graphs,
                                 const Place& place, std::uint32_t size) {
    std::vector<Triple> means;
    std::optional<runtime::Session> session;
    for (const GraphChoice& graph : graphs) {
        if (session)
            session->setGraph({graph.file, graph.settings, {}});
        else
            session.emplace(optionsFor(scene, graph, place, size));
        session->renderFrame(0);
        const image::Image picture = session->read("color");
        Triple& mean = means.emplace_back();
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x)
                for (std::uint32_t c = 0; c < 3; ++c)
                    mean[c] += static_cast<double>(picture.at(x, y, c)) / (double{1} * size * size);
    }
    return means;
}

Triple radiantIntensity(const SceneValues& scene, const GraphChoice& graph, const Place& place,
                        std::uint32_t size) {
    runtime::SessionOptions options = optionsFor(scene, graph, place, size);
    options.dumps = {"gbuffer.position"};
    runtime::Session session(options);
    session.renderFrame(0);
    return radiated(session.read("color"), session.read("gbuffer.position"), scene);
}

}  // namespace nephrite::stress
