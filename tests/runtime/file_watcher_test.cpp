// Saving a file as different editors do, and what the watcher says of it.
#include "runtime/reload/file_watcher.h"

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <future>
#include <thread>
#include <utility>

#include "scratch_folder.h"

namespace nephrite::runtime {
namespace {

using namespace std::chrono_literals;
using std::filesystem::path;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

class FileWatcherTest : public testing::Test {
  protected:
    FileWatcherTest() { watcher_.watch({file_}, false); }

    /// What is saved while `work` is done. Nothing within `most`, by default a quarter of a second: an empty
    /// list.
    template<class Work>
    std::vector<path> savedBy(Work work, std::chrono::milliseconds most = 250ms) {
        auto waiting = std::async(std::launch::async, [&] { return watcher_.wait(); });
        work();
        if (waiting.wait_for(most) != std::future_status::ready) watcher_.interrupt();
        return waiting.get();
    }

    ScratchFolder folder_;
    path file_ = folder_.write("a.glsl", "one");
    FileWatcher watcher_;
};

TEST_F(FileWatcherTest, TruncatingAndWriting) {
    EXPECT_THAT(savedBy([&] { std::ofstream(file_) << "two"; }), ElementsAre(file_));
}

TEST_F(FileWatcherTest, RenamingANewFileOverIt) {
    const auto save = [&] {
        const path fresh = folder_.write("a.glsl.swp", "two");
        std::filesystem::rename(fresh, file_);
    };
    EXPECT_THAT(savedBy(save), Contains(file_));
    EXPECT_THAT(savedBy(save), Contains(file_)) << "the file is another one now";
}

TEST_F(FileWatcherTest, MovingTheOldOneAwayFirst) {
    EXPECT_THAT(savedBy([&] {
                    std::filesystem::rename(file_, folder_.path() / "a.glsl~");
                    folder_.write("a.glsl", "two");
                }),
                Contains(file_));
}

TEST_F(FileWatcherTest, ABurstIsFewChangesAndTheLastIsAmongThem) {
    const path other = folder_.write("b.json", "{}");
    watcher_.watch({file_, other}, false);
    std::vector<path> saved = savedBy([&] {
        for (int i = 0; i < 100; ++i) {
            std::ofstream(file_) << i;
            std::ofstream(other) << i;
        }
    });
    int changes = 0;
    std::vector<path> last = saved;
    while (!saved.empty()) {
        ++changes;
        last = std::exchange(saved, savedBy([] {}));
    }
    EXPECT_THAT(last, Contains(other));
    EXPECT_LE(changes, 20);
}

TEST_F(FileWatcherTest, WritingWithoutClosing) {
    std::ofstream open(file_, std::ios::app);
    EXPECT_THAT(savedBy([&] { open << "more" << std::flush; }, 1s), ElementsAre(file_));
}

TEST_F(FileWatcherTest, WhatIsSavedBesideAFileThatIsBeingWrittenWaitsForIt) {
    const path other = folder_.write("b.json", "{}");
    watcher_.watch({file_, other}, false);
    std::ofstream slow;
    EXPECT_THAT(savedBy(
                    [&] {
                        slow.open(file_);
                        slow << "half" << std::flush;
                        std::ofstream(other) << "[]";
                    },
                    50ms),
                IsEmpty());
    EXPECT_THAT(savedBy([&] {
                    slow << " and half" << std::flush;
                    slow.close();
                }),
                ElementsAre(file_, other));
}

TEST_F(FileWatcherTest, AFileThatIsWrittenForLongDoesNotHoldTheOthersBackForEver) {
    const path other = folder_.write("b.json", "{}");
    watcher_.watch({file_, other}, false);
    std::ofstream slow(file_);
    EXPECT_THAT(savedBy(
                    [&] {
                        std::ofstream(other) << "[]";
                        for (int i = 0; i < 50; ++i) {
                            slow << i << std::flush;
                            std::this_thread::sleep_for(50ms);
                        }
                    },
                    0ms),
                Contains(other));
}

TEST_F(FileWatcherTest, OtherFilesBesideItDoNotCountButSourcesThatCome) {
    EXPECT_THAT(savedBy([&] { folder_.write("picture.png", "x"); }), IsEmpty());
    const path fresh = folder_.path() / "new.json";
    EXPECT_THAT(savedBy([&] { std::ofstream(fresh) << "{}"; }), Contains(fresh));
}

TEST_F(FileWatcherTest, ALogThatStaysOpenHoldsNothingBack) {
    std::ofstream log(folder_.path() / "log");
    watcher_.watch({file_}, true);
    EXPECT_THAT(savedBy(
                    [&] {
                        log << "a line" << std::flush;
                        std::ofstream(file_) << "two";
                        std::this_thread::sleep_for(100ms);
                    },
                    0ms),
                Contains(file_));
}

TEST_F(FileWatcherTest, FoldersCountOnlyOnTheWayToAFile) {
    const path file = folder_.write("sub/c.bin", "one");
    watcher_.watch({file_, file}, false);
    savedBy([] {});  // its folder has come
    EXPECT_THAT(savedBy([&] { std::filesystem::create_directory(folder_.path() / "other"); }), IsEmpty());
    EXPECT_THAT(
        savedBy([&] { std::filesystem::rename(folder_.path() / "sub", folder_.path() / "away"); }, 2s),
        Contains(folder_.path() / "sub"));
}

TEST_F(FileWatcherTest, WhatIsIgnoredNeverCounts) {
    const path written = folder_.path() / "timings.json";
    watcher_.ignore({written});
    EXPECT_THAT(savedBy([&] { std::ofstream(written) << "{}"; }), IsEmpty());
}

TEST_F(FileWatcherTest, AFileThatIsNotThereYet) {
    const path missing = folder_.path() / "sub" / "new.bin";
    watcher_.watch({missing}, false);
    const auto folderComes = savedBy([&] { std::filesystem::create_directory(missing.parent_path()); });
    EXPECT_THAT(folderComes, Not(IsEmpty()));
    watcher_.watch({missing}, false);
    EXPECT_THAT(savedBy([&] { std::ofstream(missing) << "x"; }), Contains(missing));
}

TEST_F(FileWatcherTest, TheFileALinkLeadsTo) {
    ScratchFolder elsewhere;
    const path target = elsewhere.write("real.glsl", "one");
    const path link = folder_.path() / "link.glsl";
    std::filesystem::create_symlink(target, link);
    watcher_.watch({link}, false);
    EXPECT_THAT(savedBy([&] { std::ofstream(target) << "two"; }), Contains(target));
}

TEST_F(FileWatcherTest, WhatIsSavedBetweenWaitsIsNotLost) {
    std::ofstream(file_) << "two";
    watcher_.watch({file_}, false);
    EXPECT_THAT(savedBy([] {}), ElementsAre(file_));
}

TEST_F(FileWatcherTest, AFileWrittenAfterItWasReadCountsAlthoughItWasNotWatchedThen) {
    ScratchFolder elsewhere;
    const path earlier = elsewhere.write("b.bin", "one");
    const path later = elsewhere.write("c.bin", "one");
    const auto written = std::filesystem::last_write_time(earlier);
    std::filesystem::last_write_time(later, written + 2s);
    watcher_.watch({earlier, later}, false, written + 1s);
    EXPECT_THAT(savedBy([] {}), ElementsAre(later));
}

TEST_F(FileWatcherTest, AnInterruptionEndsTheNextWait) {
    watcher_.interrupt();
    EXPECT_THAT(watcher_.wait(), IsEmpty());
}

TEST_F(FileWatcherTest, AFolderThatIsReplacedIsSeenByTheSlowLook) {
    const path sub = folder_.path() / "sub";
    const path file = folder_.write("sub/c.bin", "one");
    watcher_.watch({file}, false);
    std::filesystem::rename(sub, folder_.path() / "old");
    folder_.write("sub/c.bin", "other");
    EXPECT_THAT(watcher_.wait(), Contains(file));
}

}  // namespace
}  // namespace nephrite::runtime
