// A file is whole under its name or not there, whatever goes wrong on the way.
#include "image/output_file.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <utility>

#include "scratch.h"
#include "text/diagnostics.h"

namespace nephrite::image {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

class OutputFileTest : public Scratch {};

/// Lets no file of this process grow beyond some bytes while it lives, as a full disk would.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    sighandler_t handler_;
    rlimit before_{};
};

TEST_F(OutputFileTest, AppearsOnlyWhenCommitted) {
    const auto target = in("a.txt");
    OutputFile file(target);
    file.write(std::string_view("one "));
    file.write(std::string_view("two"));
    EXPECT_FALSE(std::filesystem::exists(target));
    file.commit();
    EXPECT_EQ(contents(target), "one two");
    EXPECT_THAT(listing(), ElementsAre("a.txt"));
}

TEST_F(OutputFileTest, KeepsTheOldFileAndItsPermissionsUntilReplaced) {
    const auto target = put("a.txt", "old");
    std::filesystem::permissions(target, std::filesystem::perms(0640));
    { OutputFile(target).write(std::string_view("new")); }
    EXPECT_EQ(contents(target), "old");
    EXPECT_THAT(listing(), ElementsAre("a.txt"));

    writeFile(target, std::string_view("new"));
    EXPECT_EQ(contents(target), "new");
    EXPECT_EQ(std::filesystem::status(target).permissions(), std::filesystem::perms(0640));
}

TEST_F(OutputFileTest, MovedFileIsWrittenOnce) {
    OutputFile first(in("a.txt"));
    first.write(std::string_view("one"));
    OutputFile second(std::move(first));
    second.write(std::string_view(" two"));
    second.commit();
    EXPECT_EQ(contents(in("a.txt")), "one two");
}

TEST_F(OutputFileTest, TwoWritersOfOneNameDoNotMix) {
    OutputFile first(in("a.txt"));
    OutputFile second(in("a.txt"));
    first.write(std::string_view("first"));
    second.write(std::string_view("second"));
    second.commit();
    first.commit();
    EXPECT_EQ(contents(in("a.txt")), "first");
    EXPECT_THAT(listing(), ElementsAre("a.txt"));
}

TEST_F(OutputFileTest, DiskThatFillsUpLeavesTheOldFile) {
    const auto target = put("a.bin", "old");
    const std::string large(1 << 20, 'x');
    std::string message;
    {
        const FileSizeLimit limit(4096);
        message = messageOf<RunError>([&] { writeFile(target, std::string_view(large)); });
    }
    EXPECT_THAT(message, StartsWith(target.string() + ": error: cannot be written: "));
    EXPECT_EQ(contents(target), "old");
    EXPECT_THAT(listing(), ElementsAre("a.bin"));
}

TEST_F(OutputFileTest, FullDeviceIsReported) {
    const auto target = in("full.bin");
    std::filesystem::create_symlink("/dev/full", target);
    const std::string message = messageOf<RunError>([&] { writeFile(target, std::string_view("x")); });
    EXPECT_EQ(message, target.string() + ": error: cannot be written: No space left on device");
    EXPECT_TRUE(std::filesystem::is_symlink(target));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(OutputFileTest, FollowsSymbolicLinks) {
    std::filesystem::create_directory(in("real"));
    std::filesystem::create_symlink("real/b.txt", in("a.txt"));
    writeFile(in("a.txt"), std::string_view("text"));
    EXPECT_TRUE(std::filesystem::is_symlink(in("a.txt")));
    EXPECT_EQ(contents(in("real/b.txt")), "text");
}

TEST_F(OutputFileTest, UnwritablePlacesAreNamed) {
    const auto file = put("file", "kept");
    std::filesystem::create_directory(in("folder"));
    for (const auto& [target, reason] :
         {std::pair{file / "x.exr", "Not a directory"},
          std::pair{in("none") / "x.exr", "No such file or directory"},
          std::pair{in("folder"), "Is a directory"}, std::pair{in("folder") / "", "Is a directory"}}) {
        const std::string message =
            messageOf<RunError>([&path = target] { writeFile(path, std::string_view("x")); });
        EXPECT_EQ(message, target.string() + ": error: cannot be written: " + reason);
    }
    EXPECT_EQ(contents(file), "kept");
    EXPECT_THAT(listing(), ElementsAre("file", "folder"));
    EXPECT_TRUE(std::filesystem::is_empty(in("folder")));
}

TEST_F(OutputFileTest, ProtectedPlacesAreNamed) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write anywhere";
    std::filesystem::create_directory(in("folder"));
    std::filesystem::permissions(in("folder"), std::filesystem::perms(0555));
    std::filesystem::permissions(put("file", "kept"), std::filesystem::perms(0444));
    for (const auto& target : {in("folder/x"), in("file")}) {
        EXPECT_EQ(messageOf<RunError>([&] { writeFile(target, std::string_view("x")); }),
                  target.string() + ": error: cannot be written: Permission denied");
    }
    EXPECT_EQ(contents(in("file")), "kept");
}

}  // namespace
}  // namespace nephrite::image
