// One file under several names.
#include "text/same_file.h"

#include <gtest/gtest.h>

#include <array>

#include "scratch_folder.h"

namespace nephrite {
namespace {

TEST(SameFile, IsKnownByOtherNamesAndLinks) {
    const ScratchFolder folder;
    const std::array read{folder.write("a.json", "{}"), folder.path() / "missing.json"};
    std::filesystem::create_symlink(read[0], folder.path() / "link");
    std::filesystem::create_hard_link(read[0], folder.path() / "hard");
    for (const char* name : {"a.json", "./a.json", "link", "hard"})
        EXPECT_TRUE(isAmong(folder.path() / name, read)) << name;
    for (const char* name : {"missing.json", "new.json"})
        EXPECT_FALSE(isAmong(folder.path() / name, read)) << name;
    EXPECT_FALSE(isAmong(folder.write("b.json", "{}"), read));
    EXPECT_FALSE(isAmong("", read));
}

}  // namespace
}  // namespace nephrite
