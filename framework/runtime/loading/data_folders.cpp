// Search for the data folders.
#include "runtime/loading/data_folders.h"

#include <cstdlib>
#include <optional>
#include <system_error>

#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

namespace fs = std::filesystem;

bool holdsData(const fs::path& folder) {
    std::error_code ignored;
    return fs::is_directory(folder / "passes", ignored) && fs::is_directory(folder / "shaders", ignored);
}

std::optional<fs::path> upwardsFrom(fs::path folder) {
    for (; !folder.empty(); folder = folder.parent_path()) {
        if (holdsData(folder)) return folder;
        if (folder == folder.root_path()) break;
    }
    return std::nullopt;
}

std::optional<fs::path> root() {
    if (const char* variable = std::getenv("NEPHRITE_DATA"); variable != nullptr && holdsData(variable))
        return fs::path(variable);
    std::error_code failure;
    if (const fs::path program = fs::read_symlink("/proc/self/exe", failure); !failure) {
        if (const auto found = upwardsFrom(program.parent_path())) return found;
    }
    if (holdsData(NEPHRITE_SOURCE_DIR)) return fs::path(NEPHRITE_SOURCE_DIR);
    return std::nullopt;
}

fs::path modelsBeside(const fs::path& folder) {
    if (const char* variable = std::getenv("NEPHRITE_MODELS"); variable != nullptr) return variable;
    const fs::path shared = (folder / ".." / "shared" / "models").lexically_normal();
    std::error_code ignored;
    return fs::is_directory(shared, ignored) ? shared : fs::path();
}

}  // namespace

DataFolders DataFolders::find() {
    const auto folder = root();
    if (!folder)
        throw RunError(
            "the folders passes/ and shaders/ were not found: set NEPHRITE_DATA to the folder that holds "
            "them");
    return {*folder / "passes", *folder / "shaders", *folder / "graphs" / "materials",
            *folder / "graphs" / "scenes" / "default.json", modelsBeside(*folder)};
}

}  // namespace nephrite::runtime
