// Starting the viewer with pipes to it.
#include "running_viewer.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace nephrite::view::test {
namespace {

namespace fs = std::filesystem;

std::array<int, 2> makePipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
}

}  // namespace

RunningViewer::RunningViewer() {
    for (const char* name : {"passes", "shaders", "graphs"})
        fs::copy(fs::path(NEPHRITE_SOURCE_DIR) / name, folder_.path() / name, fs::copy_options::recursive);
    const std::array<int, 2> in = makePipe();
    const std::array<int, 2> out = makePipe();
    process_ = fork();
    if (process_ == 0) {
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        dup2(open((folder() / "errors").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), STDERR_FILENO);
        setenv("NEPHRITE_DATA", folder().c_str(), 1);
        if (chdir(folder().c_str()) == 0)
            execl(NEPHRITE_PROGRAM, NEPHRITE_PROGRAM, "view", "graphs/paper.json", "--size", "96x96",
                  "--window", "1024x768", "--validation", "sync", "--script", "-", nullptr);
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    commands_ = fdopen(in[1], "w");
    answers_ = fdopen(out[0], "r");
}

RunningViewer::~RunningViewer() {
    if (process_ > 0) kill(process_, SIGKILL);
    if (process_ > 0) waitpid(process_, nullptr, 0);
    std::fclose(commands_);
    std::fclose(answers_);
}

std::string RunningViewer::tell(const std::string& command) {
    std::fputs((command + "\n").c_str(), commands_);
    std::fflush(commands_);
    std::string answer;
    for (int c = 0; (c = std::fgetc(answers_)) != EOF && c != '\n';) answer.push_back(static_cast<char>(c));
    return answer;
}

std::string RunningViewer::errors() const {
    return textOf("errors");
}

std::string RunningViewer::textOf(const fs::path& file) const {
    std::ifstream stream(folder() / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

int RunningViewer::waitForEnd() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string RunningViewer::condition() {
    int status = 0;
    if (process_ <= 0 || waitpid(process_, &status, WNOHANG) != process_) return "it runs:" + busyThreads();
    process_ = -1;
    return WIFEXITED(status) ? "it ended with status " + std::to_string(WEXITSTATUS(status))
                             : "signal " + std::to_string(WTERMSIG(status)) + " ended it";
}

double RunningViewer::secondsOf(const fs::path& stat) const {
    const std::string text = textOf(stat);
    std::istringstream words(text.substr(std::min(text.rfind(')'), text.size())));  // a name may hold blanks
    std::string word;
    double ticks = 0;
    for (int i = 2; i <= 15 && words >> word; ++i)
        if (i >= 14) ticks += std::stod(word);  // utime, stime
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double RunningViewer::processorSeconds() const {
    return secondsOf(fs::path("/proc") / std::to_string(process_) / "stat");
}

std::string RunningViewer::busyThreads() const {
    std::ostringstream text;
    for (const auto& thread : fs::directory_iterator(fs::path("/proc") / std::to_string(process_) / "task")) {
        std::string name = textOf(thread.path() / "comm");
        name.pop_back();
        text << ' ' << name << ' ' << secondsOf(thread.path() / "stat") << " s,";
    }
    return text.str();
}

}  // namespace nephrite::view::test
