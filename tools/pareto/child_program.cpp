// posix_spawn and a pipe: no shell, so that no file name needs quoting.
#include "pareto/child_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "text/diagnostics.h"

extern char** environ;

namespace nephrite::pareto {
namespace {

/// A pipe whose ends are closed with it.
class Pipe {
  public:
    Pipe() {
        if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw RunError("no pipe to another program");
    }
    ~Pipe() {
        closeWriter();
        close(ends_[0]);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void closeWriter() {
        if (ends_[1] >= 0) close(ends_[1]);
        ends_[1] = -1;
    }
    int writer() const { return ends_[1]; }

    std::string readAll() const {
        std::string text;
        std::array<char, 1 << 16> block{};
        while (true) {
            const ssize_t count = read(ends_[0], block.data(), block.size());
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) return text;
            text.append(block.data(), static_cast<std::size_t>(count));
        }
    }

  private:
    std::array<int, 2> ends_{-1, -1};
};

/// The error number of starting the program, 0 if it runs as `child`.
int start(const std::vector<std::string>& arguments, int output, pid_t& child) {
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    const int failure = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

}  // namespace

std::optional<std::string> outputOf(const std::vector<std::string>& arguments) {
    Pipe pipe;
    pid_t child = 0;
    const int failure = start(arguments, pipe.writer(), child);
    if (failure == ENOENT) return std::nullopt;
    if (failure != 0) throw RunError(fmt::format("{}: error: cannot be started", arguments[0]));
    pipe.closeWriter();
    std::string text = pipe.readAll();
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        throw RunError(fmt::format("{}: error: it failed", arguments[0]));
    return text;
}

}  // namespace nephrite::pareto
