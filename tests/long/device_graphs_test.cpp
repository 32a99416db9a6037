// All of the random graphs of which tests/runtime/device_graphs_test.cpp renders a share.
#include "runtime/random_device_check.h"

namespace nephrite::runtime {
namespace {

TEST(DeviceGraphs, ThreeHundredGiveTheBitsOfPlainOrderWithoutSharedMemory) {
    test::checkRandomDeviceGraphs(1, 301);
}

}  // namespace
}  // namespace nephrite::runtime
