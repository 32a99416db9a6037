// See draft.h.
#include "runtime/interface/draft.h"

#include <fmt/format.h>

namespace nephrite::runtime {
namespace {

constexpr std::uint32_t setIndex = 1;

}  // namespace

std::string ParameterBlock::append(std::uint32_t word, std::string_view scalar) {
    const std::size_t index = words_.size();
    words_.push_back(word);
    const std::string bits = fmt::format("parameterBlock.words[{}].{}", index / 4, "xyzw"[index % 4]);
    if (scalar == "float") return fmt::format("uintBitsToFloat({})", bits);
    if (scalar == "int") return fmt::format("int({})", bits);
    if (scalar == "bool") return fmt::format("({} != 0u)", bits);
    return bits;
}

std::vector<std::uint32_t> ParameterBlock::padded() const {
    std::vector<std::uint32_t> result = words_;
    result.resize((result.size() + 3) / 4 * 4);
    return result;
}

graph::InputRead InterfaceDraft::partOfOutput(graph::Index port) const {
    const graph::Index modified = type_.outputs[port].modifiedInput;
    return modified != graph::noIndex && read(modified).modified ? read(modified) : graph::InputRead{};
}

PortImage InterfaceDraft::imageOfOutput(graph::Index port) const {
    const graph::InputRead part = partOfOutput(port);
    return PortImage::of(plan_.resources[output(port)], part.mip, part.layer);
}

std::uint32_t InterfaceDraft::addDescriptor(PortDescriptor::Kind kind, graph::Index resource,
                                            std::uint16_t mip, std::uint16_t layer,
                                            PortDescriptor::Level level) {
    const std::uint32_t binding = nextBinding_++;
    result_.descriptors.push_back({kind, binding, resource, mip, layer, level});
    return binding;
}

void InterfaceDraft::addBuffer(const std::string& name, const std::string& element, graph::Index resource,
                               std::string_view access) {
    const std::uint32_t binding = addDescriptor(PortDescriptor::Kind::StorageBuffer, resource);
    addLine(fmt::format("layout(set = {}, binding = {}, std430) {}buffer Buffer_{} {{ {} {}[]; }};", setIndex,
                        binding, access, name, element, name));
}

NodeInterface InterfaceDraft::finish() {
    result_.parameterWords = block_.padded();
    if (!result_.parameterWords.empty()) {
        result_.descriptors.insert(result_.descriptors.begin(), {PortDescriptor::Kind::ParameterBlock, 0});
        text_.insert(0, fmt::format("layout(set = {}, binding = 0, std140) uniform ParameterBlock {{ "
                                    "uvec4 words[{}]; }} parameterBlock;\n",
                                    setIndex, result_.parameterWords.size() / 4));
    }
    result_.declarations = std::move(text_);
    return std::move(result_);
}

}  // namespace nephrite::runtime
