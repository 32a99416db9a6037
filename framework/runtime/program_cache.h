// Programs of all passes. Passes with the same code share one, also across plans.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/program.h"

namespace nephrite::runtime {

/// Programs by everything that makes them: SPIR-V, specialization constants, descriptors, raster state. Those
/// that no plan has used for a while are dropped.
class ProgramCache {
  public:
    explicit ProgramCache(ProgramContext context) : context_(std::move(context)) {}

    /// The program of a pass. Throws InputError (the shader's faults at the author's lines) or RunError.
    std::shared_ptr<const Program> programOf(const graph::Plan& plan, const graph::PlannedPass& pass,
                                             const NodeInterface& interface);
    /// By node: what the programs of a plan read of the scene. For CompileRequest::dependsOn.
    std::vector<graph::SceneParts> scenePartsOf(const graph::Plan& plan,
                                                const graph::ParameterValues& values);

    /// From now on shader files are read anew.
    void startBuild() { stages_.clear(); }
    /// A plan's programs have all been asked for: drops the oldest beyond a fixed number that nobody else
    /// holds.
    void trim();

    const ProgramContext& context() const { return context_; }
    std::size_t size() const { return programs_.size(); }
    /// Pipelines built so far; passes that share one or find theirs here build none.
    std::uint64_t built() const { return built_; }

  private:
    struct Entry {
        std::shared_ptr<const Program> program;
        std::uint64_t used = 0;  ///< counts requests
    };

    const ShaderStages& stagesOf(const graph::Plan& plan, const graph::PlannedPass& pass,
                                 const NodeInterface& interface);

    ProgramContext context_;
    std::map<std::string, ShaderStages>
        stages_;  ///< of this build, by what is generated and the shader's file
    std::map<std::string, Entry> programs_;
    std::uint64_t requests_ = 0;
    std::uint64_t built_ = 0;
};

}  // namespace nephrite::runtime
