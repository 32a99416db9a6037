// Frame numbers in names of outputs.
#include "image/frame_name.h"

#include <gtest/gtest.h>

#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

TEST(FrameNameTest, FillsInTheFrame) {
    const FrameName name("out/frame-%04d.exr");
    EXPECT_TRUE(name.isNumbered());
    EXPECT_EQ(name.of(7), "out/frame-0007.exr");
    EXPECT_EQ(name.of(123456), "out/frame-123456.exr");
    EXPECT_EQ(FrameName("%d.png").of(12), "12.png");
    EXPECT_EQ(FrameName("%09d").of(4294967295U), "4294967295");
}

TEST(FrameNameTest, OtherPercentSignsAreText) {
    for (const char* text :
         {"plain.exr", "100%.exr", "%s%n%x.exr", "%4d.exr", "%00d.exr", "%012d.exr", "%", "%0", "%05"}) {
        const FrameName name(text);
        EXPECT_FALSE(name.isNumbered()) << text;
        EXPECT_EQ(name.of(3), text);
    }
    EXPECT_EQ(FrameName("50%-%02d.exr").of(3), "50%-03.exr");
    EXPECT_EQ(FrameName("{}%02d{0}.exr").of(3), "{}03{0}.exr");
}

TEST(FrameNameTest, TwoNumbersAreRefused) {
    try {
        const FrameName name("%02d/%04d.exr");
        FAIL() << "accepted";
    } catch (const InputError& fault) {
        ASSERT_EQ(fault.faults().size(), 1U);
        EXPECT_EQ(fault.faults()[0].where.file, "%02d/%04d.exr");
        EXPECT_NE(fault.faults()[0].message.find("found two"), std::string::npos);
    }
}

}  // namespace
}  // namespace nephrite::image
