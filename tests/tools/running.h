// The program beside a test, as a user has it running.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace nephrite::tools::test {

/// Empty if there is no such file.
inline std::string contents(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// The program running in the background; killed if it still does at the end.
class Running {
  public:
    Running(const std::filesystem::path& folder, std::vector<std::string> arguments) : log_(folder / "log") {
        arguments.insert(arguments.begin(), NEPHRITE_PROGRAM);
        std::vector<char*> pointers;
        for (std::string& argument : arguments) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        process_ = fork();
        if (process_ != 0) return;
        const int file = open(log_.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        dup2(file, STDERR_FILENO);
        if (chdir(folder.c_str()) == 0) execv(NEPHRITE_PROGRAM, pointers.data());
        _exit(127);
    }
    ~Running() {
        if (process_ > 0) kill(process_, SIGKILL);
        if (process_ > 0) waitpid(process_, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    /// Ends it as Ctrl-C does. Its exit status; 128 + signal if a signal ended it.
    int interrupt() { return end(SIGINT); }
    int end(int signal) {
        kill(process_, signal);
        int status = 0;
        waitpid(process_, &status, 0);
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::string log() const { return contents(log_); }

  private:
    std::filesystem::path log_;
    pid_t process_ = -1;
};

}  // namespace nephrite::tools::test
