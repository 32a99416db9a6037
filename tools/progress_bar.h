// A bar on standard error that tells how much of long work is done; silent unless that is a terminal.
#pragma once

#include <chrono>
#include <string>

namespace nephrite::tools {

class ProgressBar {
  public:
    explicit ProgressBar(std::string label);
    /// Wipes the bar.
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `done` from 0 to 1. Draws at most ten times a second, so it may be called often.
    void show(double done);

  private:
    std::string label_;
    bool isTerminal_;
    bool isDrawn_ = false;
    double doneAtStart_ = -1;  ///< of work that was continued; not yet known: below 0
    std::chrono::steady_clock::time_point start_;
    std::chrono::steady_clock::time_point drawn_;
};

}  // namespace nephrite::tools
