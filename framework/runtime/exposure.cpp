// Exposure as a parameter of graphs.
#include "runtime/exposure.h"

#include "graph/value_readers.h"

namespace nephrite::runtime {

image::ToneMapping toneMapping(const graph::Plan& plan) {
    image::ToneMapping mapping;
    const auto* exposure = graph::findNamed(plan.graph->description.parameters, "exposure");
    if (exposure != nullptr && exposure->value.components.size() == 1 && exposure->value.components[0] != 0)
        mapping.exposure = static_cast<float>(exposure->value.components[0]);
    return mapping;
}

}  // namespace nephrite::runtime
