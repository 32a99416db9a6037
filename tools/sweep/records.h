// The rows that are done: a file each in the folder `runs` of a sweep's output, whole or not there.
#pragma once

#include <json/value.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sweep/runs.h"

namespace nephrite::sweep {

/// A row that is done.
struct Record {
    Json::Value request;                       ///< all that was asked for: see requestOf
    std::vector<std::filesystem::path> files;  ///< what it was made from, also what was looked for in vain
    std::string filesDigest;                   ///< of their contents
    Json::Value row;
};

/// Everything that decides what a run's row says, but for the contents of files, the machine and the program.
Json::Value requestOf(const Sweep& sweep, const Run& run);

class Records {
  public:
    explicit Records(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The row of a run, if it was done for the same request and from files that are still the same, and the
    /// picture it names is there.
    std::optional<Json::Value> find(const Sweep& sweep, const Run& run);
    /// Puts a row down. Throws RunError.
    void write(const Sweep& sweep, const Run& run, const std::vector<std::filesystem::path>& files,
               const Json::Value& row);

    const std::filesystem::path& folder() const { return folder_; }

  private:
    std::filesystem::path fileOf(const Run& run) const;
    std::string digestOf(const std::vector<std::filesystem::path>& files);
    std::string digestOf(const std::filesystem::path& file);

    /// Of a file met before, and when that was written.
    struct KnownFile {
        std::filesystem::file_time_type written;
        std::string digest;
    };

    std::filesystem::path folder_;
    std::map<std::filesystem::path, KnownFile> known_;
};

}  // namespace nephrite::sweep
