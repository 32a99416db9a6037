// The printer of JSON values. It recurses over values that the program itself puts together, a few levels
// deep.
#include "text/json_write.h"

#include <fmt/format.h>
#include <json/writer.h>

#include <algorithm>
#include <cmath>

namespace nephrite::json {
namespace {

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string("null");
}

bool isInOneLine(const Json::Value& value) {
    return value.empty() ||
           (value.isArray() && std::none_of(value.begin(), value.end(), [](const auto& element) {
                return element.isObject() || element.isArray();
            }));
}

void append(std::string& text, const Json::Value& value, const std::string& indent);

void appendMembers(std::string& text, const Json::Value& value, const std::string& indent) {
    const bool oneLine = isInOneLine(value);
    const std::string inner = oneLine ? indent : indent + "  ";
    const std::string separator = oneLine ? ", " : ",\n" + inner;
    text += value.isObject() ? "{" : "[";
    if (!oneLine) text += "\n" + inner;
    bool isFirst = true;
    for (auto member = value.begin(); member != value.end(); ++member) {
        if (!isFirst) text += separator;
        isFirst = false;
        if (value.isObject()) text += Json::valueToQuotedString(member.name().c_str()) + ": ";
        append(text, *member, inner);
    }
    if (!oneLine) text += "\n" + indent;
    text += value.isObject() ? "}" : "]";
}

void append(std::string& text, const Json::Value& value, const std::string& indent) {
    if (value.isObject() || value.isArray())
        appendMembers(text, value, indent);
    else if (value.type() == Json::realValue)
        text += number(value.asDouble());
    else if (value.isString())
        text += Json::valueToQuotedString(value.asCString());
    else
        text += value.isNull() ? "null" : value.asString();
}

}  // namespace

std::string toText(const Json::Value& value) {
    std::string text;
    append(text, value, "");
    return text + "\n";
}

}  // namespace nephrite::json
