// Finding programs by what makes them.
#include "runtime/program/program_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace nephrite::runtime {
namespace {

/// Drops the longest unused entries beyond `most` that nobody else holds.
template<class Entries>
void dropOldest(Entries& entries, std::size_t most) {
    std::vector<typename Entries::iterator> idle;
    for (auto entry = entries.begin(); entry != entries.end(); ++entry)
        if (entry->second.value.use_count() <= 1) idle.push_back(entry);
    std::sort(idle.begin(), idle.end(),
              [](const auto& a, const auto& b) { return a->second.used < b->second.used; });
    for (const auto& entry : idle)
        if (entries.size() > most) entries.erase(entry);
}

}  // namespace

std::shared_ptr<const Program> ProgramCache::programOf(const graph::Plan& plan,
                                                       const graph::PlannedPass& pass,
                                                       const NodeInterface& interface) {
    const auto stages = stagesOf(plan, pass, interface);
    const ProgramDescription description = describeProgram(plan, pass, interface, *stages);
    Entry<Program>& entry = programs_[keyOf(description)];
    if (!entry.value) {
        const auto start = std::chrono::steady_clock::now();
        entry.value = makeProgram(context_, description);
        ++built_;
        buildMs_ +=
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }
    entry.used = ++requests_;
    return entry.value;
}

std::shared_ptr<const ShaderStages> ProgramCache::stagesOf(const graph::Plan& plan,
                                                           const graph::PlannedPass& pass,
                                                           const NodeInterface& interface) {
    const std::string key =
        fmt::format("{}\n{}\n{}\n{}", shaderOf(context_, plan, pass).string(), static_cast<int>(pass.view),
                    interface.entryPoint, interface.declarations);
    const auto known = stages_.find(key);
    if (known != stages_.end()) {
        known->second.used = ++requests_;
        return known->second.value;
    }
    auto made = std::make_shared<const ShaderStages>(compileStages(context_, plan, pass, interface, texts_));
    stages_[key] = {made, ++requests_};
    return made;
}

std::vector<graph::SceneParts> ProgramCache::scenePartsOf(const graph::Plan& plan,
                                                          const graph::ParameterValues& values) {
    std::vector<graph::SceneParts> parts(plan.graph->nodes.size(), 0);
    for (const graph::PlannedPass& pass : plan.passes) {
        if (pass.iterations == 0) continue;
        const NodeInterface interface = nodeInterface(plan, pass, values, context_.filterable);
        parts[pass.node] = programOf(plan, pass, interface)->sceneParts;
    }
    return parts;
}

void ProgramCache::readFilesAnew() {
    const std::vector<std::filesystem::path> changed = texts_.refresh();
    const auto isChanged = [&](const std::filesystem::path& file) {
        return std::find(changed.begin(), changed.end(), file) != changed.end();
    };
    std::erase_if(stages_, [&](const auto& entry) {
        const auto& files = entry.second.value->files;
        return std::any_of(files.begin(), files.end(), isChanged);
    });
}

ProgramCache ProgramCache::copy() const {
    ProgramCache result(*this);
    result.built_ = 0;
    result.buildMs_ = 0;
    return result;
}

void ProgramCache::exchange(ProgramCache& other) {
    std::swap(texts_, other.texts_);
    std::swap(stages_, other.stages_);
    std::swap(programs_, other.programs_);
    requests_ = other.requests_ = std::max(requests_, other.requests_);
    built_ += std::exchange(other.built_, 0);
    buildMs_ += std::exchange(other.buildMs_, 0);
}

void ProgramCache::trim() {
    constexpr std::size_t most = 256;
    dropOldest(stages_, most);
    dropOldest(programs_, most);
}

}  // namespace nephrite::runtime
