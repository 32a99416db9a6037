// Tells which files were saved, however an editor does it: by renaming a new file over the old one, by
// emptying and writing it, in bursts of either, or through a link.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "text/file_descriptor.h"

namespace nephrite::runtime {

/// Of Linux (inotify), with a slow look at each file besides for file systems that report nothing.
class FileWatcher {
  public:
    /// Throws RunError if the system has no watch left to give.
    FileWatcher();

    /// From now on watches these files, there or not, and their folders for sources (*.json, *.glsl) that
    /// come or go. With `anything`, whatever happens in the folders counts. A file that was not watched
    /// before and was written after `readAt`, when its reader may have read it, counts as saved.
    void watch(const std::vector<std::filesystem::path>& files, bool anything,
               std::filesystem::file_time_type readAt = std::filesystem::file_time_type::max());

    /// These never count: what the program itself writes.
    void ignore(const std::vector<std::filesystem::path>& files);

    /// Waits until something was saved and it has been quiet for a moment: what. Nothing after interrupt().
    std::vector<std::filesystem::path> wait();
    /// Ends the wait() of now or, if there is none, the next one. From any thread.
    void interrupt();

  private:
    using Clock = std::chrono::steady_clock;

    /// What tells one saved state of a file from another.
    struct Stamp {
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        bool exists = false;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };

    static Stamp stampOf(const std::filesystem::path& file);
    void addFolder(const std::filesystem::path& folder);
    bool waitForEvents(std::chrono::milliseconds most);
    void readEvents();
    void note(const std::filesystem::path& file, unsigned what);
    bool matters(const std::filesystem::path& file, unsigned what) const;
    bool leadsToAFile(const std::filesystem::path& folder) const;
    void lookAtStamps();

    FileDescriptor events_;
    FileDescriptor interrupts_;
    std::map<int, std::filesystem::path> folders_;  ///< by watch
    std::map<std::filesystem::path, Stamp> files_;  ///< also where links lead
    std::set<std::filesystem::path> ignored_;
    std::set<std::filesystem::path> saved_;         ///< since the last wait()
    std::set<std::filesystem::path> beingWritten_;  ///< somebody writes and has not closed it yet
    bool heard_ = false;                            ///< something that matters, in the last look
    bool anything_ = false;
};

}  // namespace nephrite::runtime
