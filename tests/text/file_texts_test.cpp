// Texts as they are read from files.
#include "text/file_texts.h"

#include <gtest/gtest.h>

#include "scratch_folder.h"

namespace nephrite {
namespace {

TEST(FileTexts, AreReadOnceAndWithoutAByteOrderMark) {
    const ScratchFolder folder;
    FileTexts texts;
    const std::filesystem::path file = folder.write("a.glsl", "\xef\xbb\xbfvoid f();");
    ASSERT_NE(texts.read(file), nullptr);
    EXPECT_EQ(*texts.read(file), "void f();");
    folder.write("a.glsl", "void g();");
    EXPECT_EQ(*texts.read(file), "void f();");
    EXPECT_EQ(texts.refresh().size(), 1U);
    EXPECT_EQ(*texts.read(file), "void g();");
    EXPECT_EQ(texts.read(folder.path() / "missing.glsl"), nullptr);
}

}  // namespace
}  // namespace nephrite
