// A folder of its own for a test's files, gone with the test, and shader caches apart from the user's.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace nephrite {

/// Makes a folder, and points the driver and the renderer to caches that all test programs of this user
/// share: compiling the same shaders again for each test would take most of the tests' time.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nephrite-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
        const auto cache =
            std::filesystem::temp_directory_path() / ("nephrite-test-cache-" + std::to_string(getuid()));
        setenv("MESA_SHADER_CACHE_DIR", (cache / "mesa").c_str(), 1);
        setenv("NEPHRITE_CACHE_DIR", (cache / "nephrite").c_str(), 1);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Writes `text` to a file of that name in the folder and returns its path.
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << text;
        return file;
    }

  private:
    std::filesystem::path path_;
};

/// The test program's own, for files that many tests read; the first call makes it.
inline const ScratchFolder& sharedScratchFolder() {
    static const ScratchFolder folder;
    return folder;
}

}  // namespace nephrite
