// The descriptors of one pass: which images, buffers and parameters its program sees.
#pragma once

#include <memory>
#include <vector>

#include "gpu/descriptors.h"
#include "runtime/frame/parameter_blocks.h"
#include "runtime/interface/node_interface.h"
#include "runtime/program/program.h"
#include "runtime/resources/frame_resources.h"

namespace nephrite::runtime {

/// What the bindings of all passes of a plan are made from; all of it outlives them.
struct BindingContext {
    const ProgramContext& programs;
    const graph::Plan& plan;
    const FrameResources& resources;
    const ParameterBlocks& parameters;
    gpu::DescriptorAllocator& descriptors;
    std::uint32_t slots = 1;
};

/// A pass whose descriptors differ from frame to frame (parameters, history) has a set for each slot, others
/// one.
class PassBindings {
  public:
    PassBindings(const BindingContext& context, std::size_t pass, NodeInterface interface,
                 std::shared_ptr<const Program> program);

    /// Points a slot's set to where this frame's history is. No frame that uses the slot may be under way.
    void prepare(const BindingContext& context, std::uint32_t slot);

    /// The parameter block, which has as many words as before, holds these from now on.
    void replaceParameters(std::vector<std::uint32_t> words) { interface_.parameterWords = std::move(words); }

    const NodeInterface& interface() const { return interface_; }
    const Program& program() const { return *program_; }
    VkDescriptorSet set(std::uint32_t slot, std::uint32_t iteration) const {
        return sets_[(slots_ == 1 ? 0 : slot) * iterations_ + (iterations_ == 1 ? 0 : iteration)];
    }
    bool differsByIteration() const { return iterations_ > 1; }

  private:
    void write(const BindingContext& context, const PortDescriptor& descriptor, std::uint32_t slot,
               std::uint32_t iteration);

    std::size_t pass_;
    NodeInterface interface_;
    std::shared_ptr<const Program> program_;
    std::uint32_t slots_ = 1;              ///< that have sets of their own
    std::uint32_t iterations_ = 1;         ///< the same
    std::vector<VkDescriptorSet> sets_;    ///< by slot, then iteration
    std::vector<PortDescriptor> history_;  ///< those that change with every frame
    gpu::DescriptorWriter writer_;
};

}  // namespace nephrite::runtime
