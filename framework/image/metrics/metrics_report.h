// The metrics of a comparison as JSON and as a table.
#pragma once

#include <json/value.h>

#include <string>

#include "image/metrics/metrics.h"

namespace nephrite::image {

/// The keys of docs/comparing.md, those of the pictures' sizes left out. What has no finite value is null;
/// what was not measured is absent.
Json::Value toJson(const Metrics& metrics);

/// The same for readers, a line each.
std::string toTable(const Metrics& metrics);

}  // namespace nephrite::image
