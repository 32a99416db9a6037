// A folder of its own for a test program's files, gone when the program ends, and the driver's shader cache
// in it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace nephrite::reference {

/// Makes a folder and points the driver's shader cache into it.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "nephrite-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
        setenv("MESA_SHADER_CACHE_DIR", (path_ / "mesa").c_str(), 1);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The test program's folder; the first call makes it.
inline const std::filesystem::path& scratchFolder() {
    static const ScratchFolder folder;
    return folder.path();
}

/// Writes `text` to a file of that name in the folder and returns its path.
inline std::filesystem::path writeScratch(const std::string& name, const std::string& text) {
    const std::filesystem::path file = scratchFolder() / name;
    std::ofstream(file) << text;
    return file;
}

}  // namespace nephrite::reference
