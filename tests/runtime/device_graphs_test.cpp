// A share of the random graphs that tests/long renders all: see random_device_check.h.
#include "runtime/random_device_check.h"

namespace nephrite::runtime {
namespace {

TEST(DeviceGraphs, GiveTheBitsOfPlainOrderWithoutSharedMemory) {
    test::checkRandomDeviceGraphs(1, 60);
}

}  // namespace
}  // namespace nephrite::runtime
