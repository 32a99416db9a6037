// A node's generated GLSL while it is put together: each part of the interface adds its declarations,
// descriptors and words of the parameter block.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "graph/plan.h"
#include "runtime/interface/image_port.h"
#include "runtime/interface/node_interface.h"

namespace nephrite::runtime {

/// Words of the parameter block, handed out one by one.
class ParameterBlock {
  public:
    /// Appends a word; the GLSL that reads it back as a scalar of that type.
    std::string append(std::uint32_t word, std::string_view scalar);
    /// As whole vec4.
    std::vector<std::uint32_t> padded() const;

  private:
    std::vector<std::uint32_t> words_;
};

class InterfaceDraft {
  public:
    InterfaceDraft(const graph::Plan& plan, const graph::PlannedPass& pass)
        : plan_(plan), pass_(pass), type_(plan.typeOf(pass)) {}

    const graph::Plan& plan() const { return plan_; }
    const graph::PlannedPass& pass() const { return pass_; }
    const graph::PassType& type() const { return type_; }
    bool isRaster() const { return type_.kind == graph::PassKind::Raster; }
    bool isOverLights() const { return pass_.forEach == graph::ForEach::Lights; }
    bool isOverMips() const { return pass_.forEach == graph::ForEach::Mips; }
    bool isOverTiles() const { return pass_.tileList != graph::noIndex; }

    const graph::InputRead& read(graph::Index port) const { return plan_.inputs[pass_.inputs.first + port]; }
    /// The resource of an output.
    graph::Index output(graph::Index port) const { return plan_.outputs[pass_.outputs.first + port]; }
    /// The part of its image that an output writes: of a modified input what the input shows.
    graph::InputRead partOfOutput(graph::Index port) const;
    PortImage imageOfOutput(graph::Index port) const;

    void add(std::string_view text) { text_ += text; }
    void addLine(std::string_view text) { text_.append(text).append("\n"); }
    /// Appends a descriptor of set 1 and returns its binding.
    std::uint32_t addDescriptor(PortDescriptor::Kind kind, graph::Index resource,
                                std::uint16_t mip = graph::every, std::uint16_t layer = graph::every,
                                PortDescriptor::Level level = PortDescriptor::Level::Fixed);
    /// A storage buffer `Buffer_NAME` of `element name[]`; `access`: "readonly " or "".
    void addBuffer(const std::string& name, const std::string& element, graph::Index resource,
                   std::string_view access);
    /// The location of the next colour attachment.
    std::uint32_t nextLocation() { return nextLocation_++; }

    ParameterBlock& block() { return block_; }
    std::vector<SpecializedWord>& specialization() { return result_.specialization; }
    void setEntryPoint(std::string text) { result_.entryPoint = std::move(text); }

    /// The interface, with the parameter block in front if it has words.
    NodeInterface finish();

  private:
    const graph::Plan& plan_;
    const graph::PlannedPass& pass_;
    const graph::PassType& type_;
    ParameterBlock block_;
    std::string text_;
    std::uint32_t nextBinding_ = 1;  ///< 0 is the parameter block's
    std::uint32_t nextLocation_ = 0;
    NodeInterface result_;
};

/// The struct `params`: specialization constants and words of the parameter block.
void addParameters(InterfaceDraft& draft, const graph::ParameterValues& values);
/// Declares one output port.
void addOutput(InterfaceDraft& draft, graph::Index port);
/// Declares one input port. One that is modified reads what its output writes, so outputs come first.
void addInput(InterfaceDraft& draft, graph::Index port, const Filterable& filterable);
/// main() of the pass and what only it needs: workgroup size, tile list, the fragment.
void addEntryPoint(InterfaceDraft& draft);

}  // namespace nephrite::runtime
