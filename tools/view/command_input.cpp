// Waiting for lines on a thread of its own.
#include "view/command_input.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

#include "text/diagnostics.h"

namespace nephrite::view {
namespace {

int openInput(const std::filesystem::path& file) {
    const int descriptor = file == "-" ? dup(STDIN_FILENO) : open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        throw InputError({file.string()},
                         fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    if (std::filesystem::is_directory(file)) {
        close(descriptor);
        throw InputError({file.string()}, "cannot be read: it is a folder");
    }
    return descriptor;
}

}  // namespace

CommandInput::CommandInput(const std::filesystem::path& file, std::function<void()> onLine)
    : onLine_(std::move(onLine)), input_(openInput(file)), stop_(eventfd(0, EFD_CLOEXEC)) {
    if (stop_.get() < 0) throw RunError("cannot listen for commands");
    thread_ = std::thread([this] { read(); });
}

CommandInput::~CommandInput() {
    const std::uint64_t one = 1;
    // Its counter is far from full, so this cannot fail.
    if (write(stop_.get(), &one, sizeof one) == sizeof one) thread_.join();
}

void CommandInput::read() {
    std::string begun;
    std::array<char, 4096> bytes;
    for (;;) {
        std::array<pollfd, 2> ready{{{input_.get(), POLLIN, 0}, {stop_.get(), POLLIN, 0}}};
        if (poll(ready.data(), ready.size(), -1) < 0 && errno != EINTR) return;
        if (ready[1].revents != 0) return;
        if (ready[0].revents == 0) continue;
        const ssize_t count = ::read(input_.get(), bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        for (ssize_t i = 0; i < count; ++i) {
            const char byte = bytes[static_cast<std::size_t>(i)];
            if (byte == '\n')
                give(std::exchange(begun, {}));
            else
                begun.push_back(byte);
        }
    }
    if (!begun.empty()) give(std::move(begun));
}

void CommandInput::give(std::string line) {
    {
        const std::scoped_lock lock(mutex_);
        lines_.push_back(std::move(line));
    }
    onLine_();
}

std::optional<std::string> CommandInput::next() {
    const std::scoped_lock lock(mutex_);
    if (lines_.empty()) return std::nullopt;
    std::string line = std::move(lines_.front());
    lines_.pop_front();
    return line;
}

bool CommandInput::hasNext() const {
    const std::scoped_lock lock(mutex_);
    return !lines_.empty();
}

}  // namespace nephrite::view
