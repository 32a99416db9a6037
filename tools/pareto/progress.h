// What a long run asks of and tells its owner.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace nephrite::pareto {

struct Progress {
    std::function<bool()> stop = [] { return false; };
    /// How much of `what` is done, 0 to 1.
    std::function<void(std::string_view what, double done)> show = [](std::string_view, double) {};
    /// A line for the reader.
    std::function<void(const std::string&)> say = [](const std::string&) {};
};

}  // namespace nephrite::pareto
