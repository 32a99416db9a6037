// Comparing files by what they are.
#include "text/same_file.h"

#include <algorithm>
#include <system_error>

namespace nephrite {

bool isAmong(const std::filesystem::path& file, std::span<const std::filesystem::path> files) {
    std::error_code missing;
    if (!std::filesystem::exists(file, missing)) return false;
    return std::any_of(files.begin(), files.end(), [&](const std::filesystem::path& other) {
        return std::filesystem::equivalent(file, other, missing);
    });
}

}  // namespace nephrite
