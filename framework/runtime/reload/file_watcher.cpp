// Watching folders with inotify: a file that is replaced is another file, but its folder stays.
#include "runtime/reload/file_watcher.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "text/diagnostics.h"

namespace nephrite::runtime {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds afterSaving{6};      // another file of the same burst would have come
constexpr milliseconds afterWriting{200};   // who writes and does not close is taken as done
constexpr milliseconds longestBurst{200};   // of files each of which is whole
constexpr milliseconds longestWrite{2000};  // of a file that is not, while others are
constexpr milliseconds betweenLooks{1000};

constexpr unsigned savedEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;
constexpr unsigned writingEvents = IN_MODIFY | IN_CREATE;

std::filesystem::path normal(const std::filesystem::path& file) {
    return std::filesystem::absolute(file).lexically_normal();
}

/// The nearest folder above a file that is there.
std::filesystem::path folderOf(const std::filesystem::path& file) {
    std::filesystem::path folder = file.parent_path();
    std::error_code ignored;
    while (folder.has_relative_path() && !std::filesystem::is_directory(folder, ignored))
        folder = folder.parent_path();
    return folder;
}

bool isSource(const std::filesystem::path& file) {
    return file.extension() == ".json" || file.extension() == ".glsl";
}

}  // namespace

FileWatcher::FileWatcher()
    : events_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), interrupts_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (events_.get() < 0 || interrupts_.get() < 0)
        throw RunError(std::string("files cannot be watched: ") + std::strerror(errno));
}

FileWatcher::Stamp FileWatcher::stampOf(const std::filesystem::path& file) {
    std::error_code error;
    Stamp stamp;
    stamp.time = std::filesystem::last_write_time(file, error);
    if (error) return {};
    stamp.exists = true;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    stamp.size = error ? 0 : size;
    return stamp;
}

void FileWatcher::addFolder(const std::filesystem::path& folder) {
    const int watch = inotify_add_watch(events_.get(), folder.c_str(),
                                        savedEvents | writingEvents | IN_DELETE_SELF | IN_MOVE_SELF);
    if (watch >= 0) folders_[watch] = folder;  // where it fails, the slow look remains
}

void FileWatcher::watch(const std::vector<std::filesystem::path>& files, bool anything,
                        std::filesystem::file_time_type readAt) {
    anything_ = anything;
    std::map<std::filesystem::path, Stamp> watched;
    std::set<std::filesystem::path> folders;
    const auto add = [&](const std::filesystem::path& file) {
        const auto known = files_.find(file);
        const Stamp& stamp = watched[file] = known == files_.end() ? stampOf(file) : known->second;
        if (known == files_.end() && stamp.exists && stamp.time > readAt) saved_.insert(file);
        folders.insert(folderOf(file));
    };
    for (const std::filesystem::path& file : files) {
        add(normal(file));
        std::error_code ignored;
        const std::filesystem::path target = std::filesystem::canonical(file, ignored);
        if (!target.empty()) add(target);
    }
    files_ = std::move(watched);
    std::erase_if(folders_, [&](const auto& entry) {
        if (folders.contains(entry.second)) return false;
        inotify_rm_watch(events_.get(), entry.first);
        return true;
    });
    for (const std::filesystem::path& folder : folders) addFolder(folder);
}

void FileWatcher::ignore(const std::vector<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) ignored_.insert(normal(file));
}

/// A file that somebody is writing holds back what was saved beside it: reading all would read half of that
/// one.
std::vector<std::filesystem::path> FileWatcher::wait() {
    Clock::time_point first{};
    while (true) {
        milliseconds most = betweenLooks;
        if (!saved_.empty()) most = afterSaving;
        if (!beingWritten_.empty()) most = afterWriting;
        if (!waitForEvents(most)) return {};
        const bool quiet = !std::exchange(heard_, false);
        if (quiet) saved_.merge(std::exchange(beingWritten_, {}));
        if (quiet && saved_.empty()) lookAtStamps();
        if (saved_.empty()) continue;
        if (first == Clock::time_point{}) first = Clock::now();
        const milliseconds longest = beingWritten_.empty() ? longestBurst : longestWrite;
        if (quiet || Clock::now() - first > longest) break;
    }
    for (const std::filesystem::path& file : saved_)
        if (const auto known = files_.find(file); known != files_.end()) known->second = stampOf(file);
    const std::set<std::filesystem::path> saved = std::exchange(saved_, {});
    return {saved.begin(), saved.end()};
}

/// False if interrupted.
bool FileWatcher::waitForEvents(milliseconds most) {
    std::array<pollfd, 2> sources{{{events_.get(), POLLIN, 0}, {interrupts_.get(), POLLIN, 0}}};
    poll(sources.data(), sources.size(), static_cast<int>(most.count()));
    if ((sources[1].revents & POLLIN) != 0) {
        eventfd_t ignored = 0;
        eventfd_read(interrupts_.get(), &ignored);
        return false;
    }
    if ((sources[0].revents & POLLIN) != 0) readEvents();
    return true;
}

void FileWatcher::readEvents() {
    alignas(inotify_event) std::array<char, 16384> bytes;
    ssize_t count = 0;
    while ((count = read(events_.get(), bytes.data(), bytes.size())) > 0) {
        for (ssize_t offset = 0; offset < count;) {
            inotify_event event;
            std::memcpy(&event, bytes.data() + offset, sizeof(event));
            const char* name = bytes.data() + offset + sizeof(event);
            const auto folder = folders_.find(event.wd);
            if (folder != folders_.end() && (event.mask & (IN_DELETE_SELF | IN_MOVE_SELF)) != 0)
                folders_.erase(folder);
            else if (folder != folders_.end() && event.len > 0)
                note(folder->second / name, event.mask);
            offset += static_cast<ssize_t>(sizeof(event) + event.len);
        }
    }
}

void FileWatcher::note(const std::filesystem::path& file, unsigned what) {
    if (!matters(file, what)) return;
    heard_ = true;
    std::error_code ignored;
    const bool isWhole = (what & IN_ISDIR) != 0 || std::filesystem::is_symlink(file, ignored);
    if (isWhole || (what & savedEvents) != 0) {
        saved_.insert(file);
        beingWritten_.erase(file);
    } else {
        beingWritten_.insert(file);
    }
}

/// A file that nobody reads counts when it is whole: it may be a log that is written for ever.
bool FileWatcher::matters(const std::filesystem::path& file, unsigned what) const {
    if (ignored_.contains(file)) return false;
    if (files_.contains(file) || beingWritten_.contains(file)) return true;
    constexpr unsigned comesOrGoes = IN_CREATE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE;
    const bool mayBeRead = (what & IN_ISDIR) != 0 ? leadsToAFile(file) : isSource(file);
    if ((what & comesOrGoes) != 0 && mayBeRead) return true;
    return anything_ && (what & savedEvents) != 0;
}

/// Whether a file that is watched lies in it.
bool FileWatcher::leadsToAFile(const std::filesystem::path& folder) const {
    const auto after = files_.lower_bound(folder / "");
    return after != files_.end() &&
           std::mismatch(folder.begin(), folder.end(), after->first.begin(), after->first.end()).first ==
               folder.end();
}

void FileWatcher::lookAtStamps() {
    for (auto& [file, stamp] : files_) {
        const Stamp now = stampOf(file);
        if (now == stamp) continue;
        stamp = now;
        saved_.insert(file);
    }
}

void FileWatcher::interrupt() {
    eventfd_write(interrupts_.get(), 1);
}

}  // namespace nephrite::runtime
