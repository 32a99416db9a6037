// The viewer's commands as text.
#include "view/commands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "text/diagnostics.h"

namespace nephrite::view {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Commands, AreDividedAtBlanks) {
    EXPECT_THAT(wordsOf("  orbit 0.1\t-2 "), ElementsAre("orbit", "0.1", "-2"));
    EXPECT_TRUE(wordsOf(" \t ").empty());
}

TEST(Commands, QuotesHoldBlanksTogether) {
    EXPECT_THAT(wordsOf("window 'a b.png' \"it's\""), ElementsAre("window", "a b.png", "it's"));
    EXPECT_THROW(wordsOf("window 'a"), InputError);
}

TEST(Commands, AValueGoesOnToTheEnd) {
    EXPECT_THAT(wordsOf("set weights=[0, 1, \"x\"] "), ElementsAre("set", "weights=[0, 1, \"x\"]"));
}

TEST(Commands, NamesAndKeysAreUnique) {
    std::set<std::string> names;
    std::set<std::string> keys;
    for (const Command& command : allCommands()) {
        EXPECT_TRUE(names.insert(std::string(command.name)).second) << command.name;
        if (command.key.key != 0) {
            EXPECT_TRUE(keys.insert(keyName(command.key)).second) << keyName(command.key);
        }
        EXPECT_FALSE(command.doc.empty()) << command.name;
    }
}

TEST(Commands, AreDescribedWithTheirKeys) {
    std::ostringstream page;
    page << std::ifstream(NEPHRITE_SOURCE_DIR "/docs/viewer.md").rdbuf();
    for (const Command& command : allCommands()) {
        EXPECT_THAT(page.str(), HasSubstr("`" + std::string(command.name)));
        if (command.key.key != 0) {
            EXPECT_THAT(page.str(), HasSubstr("| " + keyName(command.key) + " |")) << command.name;
        }
    }
}

}  // namespace
}  // namespace nephrite::view
