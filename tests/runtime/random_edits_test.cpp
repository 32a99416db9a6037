// Some of the random edits of which tests/long makes a thousand.
#include "random_edits.h"

#include <gtest/gtest.h>

namespace nephrite::runtime {
namespace {

TEST(RandomEdits, NeverCostThePictureNorMemory) {
    test::RandomEdits edits(20261127, {48, 48}, Validation::Sync);
    for (int i = 0; i < 40 && !testing::Test::HasFailure(); ++i) edits.edit();
    edits.restore();
    const SessionFigures before = edits.session().figures();
    for (int i = 0; i < 20 && !testing::Test::HasFailure(); ++i) edits.edit();
    edits.restore();
    EXPECT_EQ(edits.session().figures().deviceAllocations, before.deviceAllocations);
    EXPECT_EQ(edits.session().figures().deviceBytes, before.deviceBytes);
    for (const char* kind : {"right", "wrong", "shaders", "manifests", "graphs"})
        EXPECT_GT(edits.counts().at(kind), 0) << kind;
}

}  // namespace
}  // namespace nephrite::runtime
