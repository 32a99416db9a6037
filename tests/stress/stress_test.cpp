// Runs the stress list, and makes sure that it is whole.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>

#include "scratch_folder.h"
#include "stress/axes.h"
#include "stress/cases.h"

namespace nephrite::stress {
namespace {

/// A share of the cases whose names start with `prefix`: every `parts`-th from the `part`-th on.
struct Group {
    const char* prefix;
    std::size_t part;
    std::size_t parts;
};

class Stress : public testing::TestWithParam<Group> {
  protected:
    ScratchFolder folder_;
};

TEST_P(Stress, NothingBreaks) {
    const auto start = std::chrono::steady_clock::now();
    std::size_t matching = 0;
    std::size_t cases = 0;
    std::size_t checks = 0;
    for (const Case& item : allCases({folder_.path(), {}, {}})) {
        if (!item.name.starts_with(GetParam().prefix)) continue;
        if (matching++ % GetParam().parts != GetParam().part) continue;
        const Outcome outcome = run(item);
        EXPECT_GT(outcome.checks, 0U) << outcome.name;
        for (const std::string& failure : outcome.failures) ADD_FAILURE() << outcome.name << ": " << failure;
        ++cases;
        checks += outcome.checks;
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << fmt::format("{} cases, {} checks, {:.1f} s\n", cases, checks, time.count());
    EXPECT_GT(cases, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Groups, Stress,
    testing::Values(Group{"device/", 0, 5}, Group{"device/", 1, 5}, Group{"device/", 2, 5},
                    Group{"device/", 3, 5}, Group{"device/", 4, 5}, Group{"law/", 0, 3}, Group{"law/", 1, 3},
                    Group{"law/", 2, 3}, Group{"refused/", 0, 1}, Group{"profile/", 0, 1},
                    Group{"photons/", 0, 1}, Group{"reference/", 0, 1}),
    [](const auto& group) {
        const std::string prefix = group.param.prefix;
        return fmt::format("{}{}", prefix.substr(0, prefix.size() - 1), group.param.part + 1);
    });

TEST(StressList, IsLongAndEveryCaseBelongsToAGroup) {
    const std::set<std::string> groups{"device", "law", "refused", "profile", "photons", "reference"};
    std::set<std::string> names;
    const auto cases = allCases({});
    for (const Case& item : cases) {
        EXPECT_TRUE(groups.contains(item.name.substr(0, item.name.find('/')))) << item.name;
        names.insert(item.name);
    }
    EXPECT_EQ(names.size(), cases.size()) << "two cases have the same name";
    EXPECT_GE(cases.size(), 500U);
    std::cout << cases.size() << " cases\n";
}

/// How many of the scenes have both parts in their names.
std::size_t scenesWith(const std::vector<NamedScene>& scenes, const std::string& one,
                       const std::string& other) {
    const auto has = [](const std::string& name, const std::string& part) {
        return ("+" + name + "+").find("+" + part + "+") != std::string::npos;
    };
    return static_cast<std::size_t>(std::count_if(scenes.begin(), scenes.end(), [&](const NamedScene& scene) {
        return has(scene.name, one) && has(scene.name, other);
    }));
}

TEST(StressList, HasEveryPairOfNastyValues) {
    const auto scenes = pairScenes();
    for (std::size_t a = 0; a < axes().size(); ++a)
        for (std::size_t b = a + 1; b < axes().size(); ++b)
            for (const Nasty& one : axes()[a].values)
                for (const Nasty& other : axes()[b].values)
                    EXPECT_GE(scenesWith(scenes, one.name, other.name), 1U) << one.name << ", " << other.name;
}

}  // namespace
}  // namespace nephrite::stress
