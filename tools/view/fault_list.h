// What is wrong, for the banner over the picture and for stderr: nothing a user does ends the program.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace nephrite::view {

class FaultList {
  public:
    /// Runs `action`. What it throws becomes the lines of now, and goes to stderr; if it throws nothing there
    /// are none any more. True if it threw nothing.
    bool attempt(const std::function<void()>& action);
    /// Puts lines there that no action of now threw; they go to stderr too.
    void report(std::vector<std::string> lines);
    void clear() { lines_.clear(); }

    const std::vector<std::string>& lines() const { return lines_; }

  private:
    std::vector<std::string> lines_;
};

}  // namespace nephrite::view
