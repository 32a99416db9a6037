// Reads timing dumps.
#include "timings/dump.h"

#include <algorithm>

#include <fmt/format.h>

namespace nephrite::timings {
namespace {

using json::ObjectReader;
using json::Value;

class DumpReader {
  public:
    explicit DumpReader(const Value& value) : root_(value, "a timing dump", diagnostics_) {
        dump_.file = value.where().file;
    }

    Dump read() {
        dump_.device = text("device");
        dump_.driver = text("driver");
        dump_.scene = text("scene");
        dump_.width = side("width");
        dump_.height = side("height");
        if (const auto profiled = root_.required("profiled"))
            dump_.profiled = profiled->boolean(diagnostics_, "true or false").value_or(false);
        readRows("passes", "gpuMs", true);
        readRows("rows", "cpuMs", false);
        if (const auto wall = root_.required("wallMs"))
            dump_.series.push_back({"wall", false, samples(*wall)});
        diagnostics_.throwIfErrors();
        return std::move(dump_);
    }

  private:
    std::string text(std::string_view key) {
        const auto value = root_.required(key);
        return value ? value->string(diagnostics_, "a string").value_or("") : "";
    }

    std::uint32_t side(std::string_view key) {
        const auto value = root_.required(key);
        return value ? static_cast<std::uint32_t>(
                           value->integer(diagnostics_, "a number of pixels").value_or(0))
                     : 0;
    }

    void readRows(std::string_view key, std::string_view times, bool arePasses) {
        const auto rows = root_.required(key);
        if (!rows) return;
        if (!rows->isArray())
            return diagnostics_.error(rows->where(),
                                      fmt::format("expected an array, found {}", rows->describe()));
        for (std::size_t i = 0; i < rows->size(); ++i) {
            ObjectReader row(rows->at(i), "a row of times", diagnostics_);
            const auto name = row.required("name");
            const auto values = row.required(times);
            if (!name || !values) continue;
            Series series{name->string(diagnostics_, "a name").value_or(""), arePasses, samples(*values)};
            const bool twice = std::any_of(
                dump_.series.begin(), dump_.series.end(),
                [&](const Series& other) { return other.name == series.name && other.isPass == arePasses; });
            if (twice)
                diagnostics_.error(name->where(), fmt::format("there is another {}", inQuotes(series.name)));
            dump_.series.push_back(std::move(series));
        }
    }

    std::vector<double> samples(const Value& statistics) {
        ObjectReader object(statistics, "the times of a row", diagnostics_);
        const auto values = object.required("samples");
        if (!values) return {};
        return values->numbers(diagnostics_, "an array of times").value_or(std::vector<double>());
    }

    Diagnostics diagnostics_;
    ObjectReader root_;
    Dump dump_;
};

InputError noDump(const std::string& file, std::string_view whatItIs) {
    return {
        {file},
        fmt::format("this is no timings file{}: render --timings F.json writes what is compared", whatItIs)};
}

/// Every report has the times of whole frames, so a file without any is not one with faults.
void requireDump(const Value& value) {
    if (value.isObject() && value.find("wallMs")) return;
    const bool isTrace = value.isObject() && value.find("traceEvents");
    throw noDump(value.where().file, isTrace ? " in JSON but a Chrome trace" : "");
}

}  // namespace

Dump readDump(const Value& value) {
    requireDump(value);
    return DumpReader(value).read();
}

Dump readDump(const std::filesystem::path& file) {
    try {
        return readDump(json::parseFile(file));
    } catch (const InputError& error) {
        const bool isText = error.faults().front().where.line > 0;
        if (isText && file.extension() == ".csv") throw noDump(file.string(), " in JSON but CSV");
        throw;
    }
}

}  // namespace nephrite::timings
