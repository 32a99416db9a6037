// A covering array over the axes: every pair of values of two axes occurs in at least one row.
#include <algorithm>
#include <set>
#include <tuple>

#include "stress/axes.h"

namespace nephrite::stress {
namespace {

/// Which value of each axis: 0 is none of them, i the i-th.
using Row = std::vector<std::size_t>;
/// Axis, value, a later axis, value.
using Pair = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>;

Pair pairOf(std::size_t axis, std::size_t value, std::size_t other, std::size_t otherValue) {
    return axis < other ? Pair{axis, value, other, otherValue} : Pair{other, otherValue, axis, value};
}

std::set<Pair> allPairs() {
    std::set<Pair> pairs;
    for (std::size_t a = 0; a < axes().size(); ++a)
        for (std::size_t b = a + 1; b < axes().size(); ++b)
            for (std::size_t i = 1; i <= axes()[a].values.size(); ++i)
                for (std::size_t j = 1; j <= axes()[b].values.size(); ++j) pairs.emplace(a, i, b, j);
    return pairs;
}

/// The value of `axis` with which most missing pairs occur, given the axes chosen so far.
std::size_t bestValue(std::size_t axis, const Row& row, const std::vector<bool>& chosen,
                      const std::set<Pair>& missing) {
    std::size_t best = 0;
    std::size_t most = 0;
    for (std::size_t value = 1; value <= axes()[axis].values.size(); ++value) {
        std::size_t count = 0;
        for (std::size_t other = 0; other < row.size(); ++other)
            if (chosen[other]) count += missing.count(pairOf(axis, value, other, row[other]));
        if (count > most) {
            most = count;
            best = value;
        }
    }
    return best;
}

NamedScene sceneOf(const Row& row) {
    NamedScene made;
    for (std::size_t axis = 0; axis < row.size(); ++axis) {
        if (row[axis] == 0) continue;
        const Nasty& nasty = axes()[axis].values[row[axis] - 1];
        nasty.apply(made.scene);
        made.name += (made.name.empty() ? "" : "+") + nasty.name;
    }
    return made;
}

}  // namespace

std::vector<NamedScene> pairScenes() {
    std::vector<NamedScene> scenes;
    std::set<Pair> missing = allPairs();
    while (!missing.empty()) {
        // A row starts with a pair that is missing, so that each row takes at least one away.
        const auto [first, firstValue, second, secondValue] = *missing.begin();
        Row row(axes().size(), 0);
        std::vector<bool> chosen(axes().size(), false);
        row[first] = firstValue;
        row[second] = secondValue;
        chosen[first] = chosen[second] = true;
        for (std::size_t axis = 0; axis < row.size(); ++axis) {
            if (chosen[axis]) continue;
            row[axis] = bestValue(axis, row, chosen, missing);
            chosen[axis] = true;
        }
        for (std::size_t a = 0; a < row.size(); ++a)
            for (std::size_t b = a + 1; b < row.size(); ++b) missing.erase({a, row[a], b, row[b]});
        scenes.push_back(sceneOf(row));
    }
    return scenes;
}

}  // namespace nephrite::stress
