// See validator.h.
#include "schema/validator.h"

#include <fmt/format.h>
#include <json/writer.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "scratch_folder.h"

namespace nephrite::tests {
namespace {

std::string onOneLine(const Json::Value& value) {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "";
    builder["precision"] = 17;
    return Json::writeString(builder, value);
}

}  // namespace

std::vector<Verdict> validate(const std::string& schema, const std::vector<Json::Value>& instances) {
    const ScratchFolder folder;
    const auto in = [&](const char* name) { return (folder.path() / name).string(); };
    std::ofstream(in("schema.json")) << schema;
    std::ofstream lines(in("instances"));
    for (const Json::Value& instance : instances) lines << onOneLine(instance) << '\n';
    lines.close();
    const std::string command =
        fmt::format("python3 '{}/tests/schema/validate.py' '{}' < '{}' > '{}' 2> '{}'", NEPHRITE_SOURCE_DIR,
                    in("schema.json"), in("instances"), in("verdicts"), in("errors"));
    if (std::system(command.c_str()) != 0) {
        std::ifstream errors(in("errors"));
        throw std::runtime_error(std::string(std::istreambuf_iterator<char>(errors), {}));
    }
    std::vector<Verdict> verdicts;
    std::ifstream output(in("verdicts"));
    for (std::string line; std::getline(output, line);) verdicts.push_back({line == "accepted", line});
    if (verdicts.size() != instances.size()) throw std::runtime_error("a verdict is missing");
    return verdicts;
}

}  // namespace nephrite::tests
