// A script's commands, run one by one between frames.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "view/command_input.h"

namespace nephrite::view {

class Viewer;

class Script {
  public:
    /// As CommandInput.
    Script(std::filesystem::path file, std::function<void()> onLine);

    bool hasNext() const { return input_.hasNext(); }
    /// Runs the next line, which must be there. Throws what the command throws; from a file an InputError
    /// placed in that line.
    void runNext(Viewer& viewer);
    /// Lines of faults as those of the last line that was run, `FILE:LINE:1: error: ...`; as they are if the
    /// script is standard input.
    std::vector<std::string> placed(std::vector<std::string> lines) const;
    /// What the viewer answers to the last command.
    void answer(const std::string& text);
    /// Throws InputError if a command of a file failed. Who writes to standard input has read the answers.
    void requireAllDone() const;

  private:
    bool isFile() const { return file_ != "-"; }

    std::filesystem::path file_;
    CommandInput input_;
    std::uint32_t line_ = 0;
    std::size_t failures_ = 0;
};

}  // namespace nephrite::view
