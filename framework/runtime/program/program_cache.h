// Programs of all passes. Passes with the same code share one, also across plans.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/program/program.h"
#include "text/file_texts.h"

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

    /// Reads the shader files anew. Until then everything is made from the texts of the last time, so that a
    /// file that an editor is at hurts nobody.
    void readFilesAnew();
    /// Every file that programs were made from, also those that are not there but would have been taken.
    std::vector<std::filesystem::path> files() const { return texts_.files(); }
    /// A copy to build with on another thread, for exchange(). It has built nothing yet.
    ProgramCache copy() const;
    /// What is known here and there changes places; pipelines built are counted on.
    void exchange(ProgramCache& other);
    /// A plan's programs have all been asked for: drops the oldest beyond a fixed number that nobody else
    /// holds.
    void trim();

    const ProgramContext& context() const { return context_; }
    std::size_t size() const { return programs_.size(); }
    /// Pipelines built so far; passes that share one or find theirs here build none.
    std::uint64_t built() const { return built_; }
    /// Milliseconds that the driver took for them.
    double buildMs() const { return buildMs_; }

  private:
    template<class Value>
    struct Entry {
        std::shared_ptr<const Value> value;
        std::uint64_t used = 0;  ///< counts requests
    };
    template<class Value>
    using Entries = std::map<std::string, Entry<Value>>;

    std::shared_ptr<const ShaderStages> stagesOf(const graph::Plan& plan, const graph::PlannedPass& pass,
                                                 const NodeInterface& interface);

    ProgramContext context_;
    FileTexts texts_;
    Entries<ShaderStages> stages_;  ///< of these texts, by what is generated and the shader's file
    Entries<Program> programs_;
    std::uint64_t requests_ = 0;
    std::uint64_t built_ = 0;
    double buildMs_ = 0;
};

}  // namespace nephrite::runtime
