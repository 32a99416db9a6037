// A written Chrome trace, read back.
#pragma once

#include <json/reader.h>
#include <json/writer.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace nephrite::timings::test {

inline Json::Value parsed(const std::string& text) {
    std::istringstream stream(text);
    Json::Value value;
    std::string faults;
    Json::CharReaderBuilder builder;
    Json::CharReaderBuilder::strictMode(&builder.settings_);
    if (!Json::parseFromStream(builder, stream, &value, &faults)) throw std::runtime_error(faults);
    return value;
}

/// Events of a phase ("X": slices, "i": instants), in the order of the file.
inline std::vector<Json::Value> eventsOf(const Json::Value& trace, const std::string& phase) {
    std::vector<Json::Value> events;
    for (const Json::Value& event : trace["traceEvents"])
        if (event["ph"] == phase) events.push_back(event);
    return events;
}

/// Nanoseconds as Perfetto reads them: what is below one is cut off.
inline std::int64_t nanoseconds(const Json::Value& microseconds) {
    return static_cast<std::int64_t>(microseconds.asDouble() * 1000);
}
inline std::int64_t beginOf(const Json::Value& slice) {
    return nanoseconds(slice["ts"]);
}
inline std::int64_t endOf(const Json::Value& slice) {
    return nanoseconds(slice["ts"]) + nanoseconds(slice["dur"]);
}

/// Whether two slices of a lane lie one in the other or apart.
inline bool nest(const Json::Value& a, const Json::Value& b) {
    const bool apart = endOf(a) <= beginOf(b) || endOf(b) <= beginOf(a);
    const bool aInB = beginOf(b) <= beginOf(a) && endOf(a) <= endOf(b);
    const bool bInA = beginOf(a) <= beginOf(b) && endOf(b) <= endOf(a);
    return apart || aInB || bInA;
}

}  // namespace nephrite::timings::test
