// Finding programs by what makes them.
#include "runtime/program_cache.h"

#include <fmt/format.h>

#include <algorithm>

namespace nephrite::runtime {

std::shared_ptr<const Program> ProgramCache::programOf(const graph::Plan& plan,
                                                       const graph::PlannedPass& pass,
                                                       const NodeInterface& interface) {
    const ShaderStages& stages = stagesOf(plan, pass, interface);
    const ProgramDescription description = describeProgram(plan, pass, interface, stages);
    Entry& entry = programs_[keyOf(description)];
    if (!entry.program) {
        entry.program = makeProgram(context_, description);
        ++built_;
    }
    entry.used = ++requests_;
    return entry.program;
}

const ShaderStages& ProgramCache::stagesOf(const graph::Plan& plan, const graph::PlannedPass& pass,
                                           const NodeInterface& interface) {
    const std::string key =
        fmt::format("{}\n{}\n{}\n{}", shaderOf(context_, plan, pass).string(), static_cast<int>(pass.view),
                    interface.entryPoint, interface.declarations);
    const auto known = stages_.find(key);
    if (known != stages_.end()) return known->second;
    return stages_.emplace(key, compileStages(context_, plan, pass, interface)).first->second;
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

void ProgramCache::trim() {
    constexpr std::size_t most = 256;
    std::vector<std::pair<std::uint64_t, std::map<std::string, Entry>::iterator>> idle;
    for (auto entry = programs_.begin(); entry != programs_.end(); ++entry)
        if (entry->second.program.use_count() <= 1) idle.emplace_back(entry->second.used, entry);
    std::sort(idle.begin(), idle.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [used, entry] : idle)
        if (programs_.size() > most) programs_.erase(entry);
}

}  // namespace nephrite::runtime
