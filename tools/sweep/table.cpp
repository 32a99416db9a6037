// Rows, flattened into columns.
#include "sweep/table.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "pareto/csv.h"
#include "text/json_write.h"

namespace nephrite::sweep {
namespace {

/// What leads to a value in a row, and the value as a field.
using Fields = std::vector<std::pair<std::string, std::string>>;

std::string fieldOf(const Json::Value& value) {
    if (value.isNull()) return {};
    if (value.isString()) return value.asString();
    if (value.type() == Json::realValue) return pareto::csvField(value.asDouble());
    std::string text = json::toText(value);
    text.pop_back();  // its line break
    return text;
}

/// A value, or its members one by one. Rows are a few levels deep.
void flatten(const std::string& column, const Json::Value& value, Fields& fields) {
    if (value.isObject()) {
        for (auto member = value.begin(); member != value.end(); ++member)
            flatten(column + "." + member.name(), *member, fields);
    } else if (value.isArray() && value.size() == 3 && !value[0].isObject()) {
        constexpr std::array<const char*, 3> channels{".R", ".G", ".B"};
        for (Json::ArrayIndex i = 0; i < 3; ++i) flatten(column + channels[i], value[i], fields);
    } else {
        fields.emplace_back(column, fieldOf(value));
    }
}

void flattenParameters(const Json::Value& parameters, Fields& fields) {
    for (auto member = parameters.begin(); member != parameters.end(); ++member)
        fields.emplace_back("parameters." + member.name(), fieldOf(*member));
}

void flattenTimes(const std::string& column, const Json::Value& statistics, Fields& fields) {
    for (auto member = statistics.begin(); member != statistics.end(); ++member)
        fields.emplace_back(column + "." + member.name(), pareto::csvTime(member->asDouble()));
}

void flattenPasses(const Json::Value& passes, Fields& fields) {
    for (const Json::Value& pass : passes)
        for (const char* clock : {"gpuMs", "cpuMs"})
            flattenTimes("passes." + pass["name"].asString() + "." + clock, pass[clock], fields);
}

Fields fieldsOf(const Json::Value& row) {
    Fields fields;
    for (const char* key :
         {"id", "scene", "graph", "width", "height", "parameters", "error", "wallMs", "metrics", "frames",
          "warmup", "device", "driver", "commit", "picture", "passes"}) {
        const std::string_view name = key;
        if (!row.isMember(key)) continue;
        if (name == "parameters")
            flattenParameters(row[key], fields);
        else if (name == "passes")
            flattenPasses(row[key], fields);
        else if (name == "wallMs")
            flattenTimes(key, row[key], fields);
        else
            flatten(key, row[key], fields);
    }
    return fields;
}

}  // namespace

std::string rowsAsJson(const std::string& name, const std::vector<Json::Value>& rows) {
    Json::Value root;
    root["sweep"] = name;
    root["runs"] = Json::arrayValue;
    for (const Json::Value& row : rows) root["runs"].append(row);
    return json::toText(root);
}

std::string rowsAsCsv(const std::vector<Json::Value>& rows) {
    std::vector<std::map<std::string, std::string>> lines;
    std::vector<std::string> columns;
    std::map<std::string, bool> isKnown;
    for (const Json::Value& row : rows) {
        auto& line = lines.emplace_back();
        for (const auto& [column, field] : fieldsOf(row)) {
            line[column] = field;
            if (isKnown.emplace(column, true).second) columns.push_back(column);
        }
    }
    pareto::CsvLine head;
    for (const std::string& column : columns) head.add(column);
    std::string text = head.text();
    for (auto& line : lines) {
        pareto::CsvLine fields;
        for (const std::string& column : columns) fields.add(line[column]);
        text += fields.text();
    }
    return text;
}

}  // namespace nephrite::sweep
