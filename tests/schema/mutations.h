// Faulty files, made from a good one by one change each: a value of another type, a key missing or unknown, a
// number out of range, an array of another length.
#pragma once

#include <json/value.h>

#include <string>
#include <vector>

namespace nephrite::tests {

struct Mutation {
    std::string what;  ///< the place and the change, "/nodes/blur/in: number"
    Json::Value value;
};

/// Every value of `base` changed in every way, one at a time; some of the results are still good.
std::vector<Mutation> mutationsOf(const Json::Value& base);

}  // namespace nephrite::tests
