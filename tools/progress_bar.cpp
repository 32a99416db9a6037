// Drawing the bar.
#include "progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace nephrite::tools {
namespace {

std::string remaining(double seconds) {
    const auto whole = static_cast<long>(seconds);
    if (whole >= 3600) return fmt::format("{} h {:02} min left", whole / 3600, whole / 60 % 60);
    if (whole >= 60) return fmt::format("{} min {:02} s left", whole / 60, whole % 60);
    return fmt::format("{} s left", whole);
}

}  // namespace

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      isTerminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
    if (isDrawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(double done) {
    const auto now = std::chrono::steady_clock::now();
    if (!isTerminal_ || (isDrawn_ && now - drawn_ < std::chrono::milliseconds(100))) return;
    if (doneAtStart_ < 0) doneAtStart_ = done;
    constexpr int width = 40;
    const int filled = std::clamp(static_cast<int>(done * width), 0, width);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double share = done - doneAtStart_;
    const std::string left = share > 0.001 ? remaining(seconds * (1 - done) / share) : "";
    fmt::print(stderr, "\r\033[K{} [{:#<{}}{:.<{}}] {:5.1f} % {}", label_, "", filled, "", width - filled,
               100 * done, left);
    std::fflush(stderr);
    isDrawn_ = true;
    drawn_ = now;
}

}  // namespace nephrite::tools
