// Runs the program as a user would and keeps what it answered.
#pragma once

#include <filesystem>
#include <string>

namespace nephrite::tools::test {

struct Answer {
    int status = -1;     ///< exit status; 128 + signal if it was killed
    std::string output;  ///< standard output
    std::string errors;  ///< standard error
};

/// A folder for a test's files, removed at the end, with the driver's and the program's caches in it.
class Workplace {
  public:
    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    /// Runs `nephrite ARGUMENTS` in the folder, through the shell.
    Answer run(const std::string& arguments) const;
    /// Files in the folder that the test did not write.
    bool isThere(const std::string& name) const { return std::filesystem::exists(path_ / name); }

  private:
    std::filesystem::path path_;
};

/// graphs/NAME of the source tree.
std::string graphFile(const std::string& name);
std::string sceneFile(const std::string& name);

}  // namespace nephrite::tools::test
