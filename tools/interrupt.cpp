// The signal handler behind interrupted().
#include "interrupt.h"

#include <atomic>
#include <csignal>

namespace nephrite::tools {
namespace {

// A signal handler can reach nothing but static storage.
std::atomic<bool>& flag() {
    static std::atomic<bool> raised{false};
    return raised;
}

extern "C" void onInterrupt(int) {
    flag() = true;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

}  // namespace

void catchInterrupts() {
    flag() = false;
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
}

bool interrupted() {
    return flag();
}

}  // namespace nephrite::tools
