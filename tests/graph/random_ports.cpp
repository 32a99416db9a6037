// See random_ports.h.
#include "graph/random_ports.h"

namespace nephrite::graph::tests {

PortReference reference(const RandomPort& port, Chance& chance) {
    PortReference result;
    result.node = port.nodeName;
    result.port = port.portName;
    if (port.mips > 1 && chance.oneIn(2)) result.mip = chance.below(port.mips);
    if (port.layers > 1 && chance.oneIn(2)) result.layer = chance.below(port.layers);
    return result;
}

void expect(InputPort& input, const RandomPort& port) {
    if (port.sort == PortSort::Buffer) input.bufferElement = "vec4";
    if (port.sort == PortSort::Uint) input.format = Format::r32u;
}

}  // namespace nephrite::graph::tests
