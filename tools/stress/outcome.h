// What a stress case found: how many things it checked and what failed.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace nephrite::stress {

struct Outcome {
    std::string name;  ///< of the case
    std::size_t checks = 0;
    std::vector<std::string> failures;

    /// Counts a check; one that does not hold leaves its message.
    void check(bool holds, const std::string& message) {
        ++checks;
        if (!holds) failures.push_back(message);
    }
};

/// One case of the list. `run` adds its checks to an outcome; what it throws counts as a failure of the case.
struct Case {
    std::string name;  ///< GROUP/WHAT: "device/sphere+g-forward"
    std::function<void(Outcome&)> run;
};

}  // namespace nephrite::stress
