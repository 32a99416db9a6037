// `nephrite view` on a copy of the project's data, told what to do by lines as a user's script would.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "scratch_folder.h"

namespace nephrite::view::test {

class RunningViewer {
  public:
    /// Opens graphs/paper.json under synchronization validation.
    RunningViewer();
    ~RunningViewer();
    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;

    /// Runs a command; its answer, "ok" or what is wrong, once its picture is shown.
    std::string tell(const std::string& command);
    /// What was printed to standard error so far.
    std::string errors() const;
    /// Waits for the program's end; its exit status.
    int waitForEnd();
    /// What has become of the process, for a failure's message.
    std::string condition();

    /// Seconds of processor time so far.
    double processorSeconds() const;
    const std::filesystem::path& folder() const { return folder_.path(); }
    std::string textOf(const std::filesystem::path& file) const;
    void write(const std::string& file, const std::string& text) const { folder_.write(file, text); }

  private:
    double secondsOf(const std::filesystem::path& stat) const;
    /// Each thread's name and processor time.
    std::string busyThreads() const;

    ScratchFolder folder_;
    pid_t process_ = -1;
    FILE* commands_ = nullptr;
    FILE* answers_ = nullptr;
};

}  // namespace nephrite::view::test
