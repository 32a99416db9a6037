// Keeps what a session shows the same as its files: shaders and all they include, manifests, graph, scene,
// meshes and textures. What was saved is built aside on another thread, taken over between two frames if it
// is right, and otherwise named and left out.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "runtime/draft.h"
#include "runtime/reload/file_watcher.h"
#include "text/diagnostics.h"

namespace nephrite::runtime {

/// Milliseconds of a reload. What a driver leaves for when a pipeline first runs belongs to the next frame.
struct ReloadTimes {
    double noticeMs = 0;   ///< from the file's time of writing to knowing of it
    double readMs = 0;     ///< to a linked graph and a scene
    double compileMs = 0;  ///< plan, GLSL to SPIR-V
    double driverMs = 0;   ///< SPIR-V to pipelines
    double waitMs = 0;     ///< for the frame under way and for poll()
    double swapMs = 0;     ///< images, descriptors, taking over

    /// Without what the driver does and what a frame takes.
    double ownMs() const { return noticeMs + readMs + compileMs + swapMs; }
};

/// What came of files that were saved.
struct Reload {
    std::vector<std::filesystem::path> files;  ///< that were saved
    bool shown = false;                        ///< false: wrong, the session goes on as it was
    std::vector<Diagnostic> faults;
    ReloadTimes times;
    std::uint64_t pipelines = 0;  ///< built anew
};

/// The line a user is told: what was read anew and how long it took, or the faults, a line each.
std::vector<std::string> toLines(const Reload& reload);

class LiveReload {
  public:
    /// The session must outlive it and stay where it is. `onReady`, if given, is called from another thread
    /// when poll() has something to do. `written` are files that the program itself writes: they never count.
    /// Throws RunError if files cannot be watched.
    explicit LiveReload(Session& session, std::function<void()> onReady = {},
                        const std::vector<std::filesystem::path>& written = {});
    ~LiveReload();
    LiveReload(const LiveReload&) = delete;
    LiveReload& operator=(const LiveReload&) = delete;

    /// To be called between frames, by whoever renders them: changes the session to what was saved. Nothing
    /// if there is nothing new. Throws RunError if the device was lost.
    std::optional<Reload> poll();
    /// Waits until poll() has something to do; false if it had not after `most`.
    bool wait(std::chrono::milliseconds most);
    /// The session was given another graph or scene by other means: from now on that one's files are watched.
    void watchAnew();
    /// After other means have changed what stood in the way of files that were refused: tries them again.
    /// Nothing happens if none were.
    void tryAgain();

    /// What is wrong with the files as they are; empty when the session shows what they say.
    const std::vector<Diagnostic>& faults() const { return faults_; }

  private:
    /// What the thread is to do next.
    struct Task {
        std::unique_ptr<Draft> draft;
        std::vector<std::filesystem::path> files;  ///< to watch
        std::filesystem::file_time_type readAt;    ///< when their reading began
        bool anything = false;  ///< whatever happens beside them counts: something missing may be there
        bool atOnce = false;    ///< without waiting for another change
        std::vector<std::filesystem::path> saved;  ///< why at once
    };
    struct Result {
        std::unique_ptr<Draft> draft;
        Reload reload;
        std::filesystem::file_time_type readAt;  ///< when its reading began
        std::chrono::steady_clock::time_point built;
    };

    void run();
    bool takeTask(std::optional<Task>& task);
    void work(Task task);
    void give(Task task);
    void giveAtOnce(std::vector<std::filesystem::path> saved, std::filesystem::file_time_type readAt);
    Task nextTask(std::filesystem::file_time_type readAt, const Draft* failed = nullptr) const;
    bool adopt(Result& result);

    Session& session_;
    std::function<void()> onReady_;
    std::vector<Diagnostic> faults_;
    std::vector<std::filesystem::path> refused_;  ///< the files that have faults_
    FileWatcher watcher_;                         ///< of the thread, but for interrupt()
    bool isWarm_ = false;                         ///< of the thread: the compiler is ready

    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Task> task_;      ///< guarded by mutex_
    std::optional<Result> result_;  ///< guarded by mutex_
    bool stop_ = false;             ///< guarded by mutex_
    std::thread thread_;
};

}  // namespace nephrite::runtime
