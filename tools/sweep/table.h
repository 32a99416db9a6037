// The rows of a sweep as files.
#pragma once

#include <json/value.h>

#include <string>
#include <vector>

namespace nephrite::sweep {

/// {"sweep": name, "runs": rows}.
std::string rowsAsJson(const std::string& name, const std::vector<Json::Value>& rows);

/// A line a row. Members of objects are columns `wallMs.median`, channels `metrics.relRMSE.R`, passes
/// `passes.NAME.gpuMs.median`; a column that a row lacks is empty there. Times are rounded to nanoseconds,
/// other numbers have the 17 digits that give the same number back.
std::string rowsAsCsv(const std::vector<Json::Value>& rows);

}  // namespace nephrite::sweep
