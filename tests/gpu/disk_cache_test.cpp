// The disk cache itself: whole keys, several threads, where it lives.
#include "gpu/disk_cache.h"

#include <gtest/gtest.h>

#include <thread>

#include "gpu/support.h"

namespace nephrite::gpu {
namespace {

using test::Environment;
using test::TemporaryFolder;

std::vector<std::byte> bytes(std::string_view text) {
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

TEST(DiskCache, KeepsValuesByKindAndKey) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path() / "made" / "when needed");
    EXPECT_FALSE(cache.read("kind", "key").has_value());
    EXPECT_TRUE(cache.write("kind", "key", bytes("value")));
    EXPECT_TRUE(cache.write("kind", "empty", {}));
    EXPECT_EQ(cache.read("kind", "key"), bytes("value"));
    EXPECT_EQ(cache.read("kind", "empty"), std::vector<std::byte>());
    EXPECT_FALSE(cache.read("other", "key").has_value());
    EXPECT_FALSE(cache.read("kind", "key2").has_value());
    EXPECT_TRUE(cache.write("kind", "key", bytes("new value")));
    EXPECT_EQ(cache.read("kind", "key"), bytes("new value"));
}

TEST(DiskCache, NeverAnswersForAnotherKeyOfTheSameHash) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path());
    ASSERT_TRUE(cache.write("kind", "one", bytes("value of one")));
    // What a collision of the hashes would look like: the file of one key where another key is looked for.
    std::filesystem::copy_file(cache.fileOf("kind", "one"), cache.fileOf("kind", "two"));
    EXPECT_FALSE(cache.read("kind", "two").has_value());
    EXPECT_TRUE(cache.write("kind", "two", bytes("value of two")));
    EXPECT_EQ(cache.read("kind", "two"), bytes("value of two"));
}

TEST(DiskCache, WithoutAFolderKeepsNothing) {
    const DiskCache cache;
    EXPECT_FALSE(cache.write("kind", "key", bytes("value")));
    EXPECT_FALSE(cache.read("kind", "key").has_value());
}

TEST(DiskCache, ThreadsSeeWholeValues) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path());
    const std::vector<std::vector<std::byte>> values{bytes(std::string(5000, 'a')),
                                                     bytes(std::string(90000, 'b'))};
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (std::size_t index = 0; index < wrong.size(); ++index) {
        threads.emplace_back([&, index] {
            for (int round = 0; round < 100; ++round) {
                cache.write("kind", "key", values[index % values.size()]);
                const auto found = cache.read("kind", "key");
                if (found && *found != values[0] && *found != values[1]) ++wrong[index];
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
    EXPECT_TRUE(cache.read("kind", "key").has_value());
}

TEST(DiskCache, LivesWhereTheEnvironmentSays) {
    const Environment home("HOME", "/home/someone");
    {
        const Environment own("NEPHRITE_CACHE_DIR", "/somewhere/own");
        const Environment xdg("XDG_CACHE_HOME", "/somewhere/cache");
        EXPECT_EQ(defaultCacheFolder(), "/somewhere/own");
    }
    const Environment own("NEPHRITE_CACHE_DIR", std::nullopt);
    {
        const Environment xdg("XDG_CACHE_HOME", "/somewhere/cache");
        EXPECT_EQ(defaultCacheFolder(), "/somewhere/cache/nephrite");
    }
    {
        const Environment xdg("XDG_CACHE_HOME", "relative");
        EXPECT_EQ(defaultCacheFolder(), "/home/someone/.cache/nephrite");
    }
    const Environment xdg("XDG_CACHE_HOME", std::nullopt);
    EXPECT_EQ(defaultCacheFolder(), "/home/someone/.cache/nephrite");
    const Environment noHome("HOME", std::nullopt);
    EXPECT_FALSE(defaultCacheFolder().has_value());
}

}  // namespace
}  // namespace nephrite::gpu
