// Stacks of a single layer.
#include "scattering/layer_stack.h"

namespace nephrite::scattering {

LayerStack layerStackOf(const Medium& medium, double thickness) {
    return {{{thickness, medium.absorption, medium.scattering}}, medium.g, medium.eta};
}

}  // namespace nephrite::scattering
