// What a validator that is not ours says of files and schemas.
#pragma once

#include <json/value.h>

#include <string>
#include <vector>

namespace nephrite::tests {

/// What the validator says of one instance.
struct Verdict {
    bool accepted = false;
    std::string words;  ///< as validate.py prints it
};

/// The verdicts of python3-jsonschema's draft 4 validator, in the order of `instances`. Throws
/// std::runtime_error if it cannot run or finds the schema itself invalid.
std::vector<Verdict> validate(const std::string& schema, const std::vector<Json::Value>& instances);

}  // namespace nephrite::tests
