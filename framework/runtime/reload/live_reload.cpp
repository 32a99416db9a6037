// The thread that builds what was saved, and taking over what it built.
#include "runtime/reload/live_reload.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace nephrite::runtime {
namespace {

using Clock = std::chrono::steady_clock;
using FileClock = std::chrono::file_clock;

double milliseconds(auto duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

/// Since the last of these files was written.
double sinceSaved(const std::vector<std::filesystem::path>& files) {
    const FileClock::time_point now = FileClock::now();
    double least = 0;
    bool any = false;
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        const auto time = std::filesystem::last_write_time(file, error);
        if (error) continue;
        const double since = std::max(milliseconds(now - time), 0.0);
        least = any ? std::min(least, since) : since;
        any = true;
    }
    // A file that was moved into place, or touched, may be of long ago.
    constexpr double longest = 1000;
    return least > longest ? 0 : least;
}

/// The first few; a renamed folder may bring many.
std::string namesOf(const std::vector<std::filesystem::path>& files) {
    constexpr std::size_t most = 3;
    std::string names;
    for (const std::filesystem::path& file : std::span(files).first(std::min(files.size(), most))) {
        std::error_code ignored;  // a link to itself is no file either
        const bool isThere = std::filesystem::exists(file, ignored);
        names += fmt::format("{}{}{}", names.empty() ? "" : ", ", file.filename().string(),
                             isThere ? "" : " (gone)");
    }
    return files.size() > most ? fmt::format("{} and {} more", names, files.size() - most) : names;
}

std::vector<Diagnostic> faultsOf(const std::exception& error) {
    if (const auto* input = dynamic_cast<const InputError*>(&error)) return input->faults();
    return {{{"nephrite"}, error.what()}};
}

}  // namespace

std::vector<std::string> toLines(const Reload& reload) {
    std::vector<std::string> lines;
    for (const Diagnostic& fault : reload.faults) lines.push_back(toLine(fault));
    if (!reload.shown) return lines;
    const ReloadTimes& times = reload.times;
    lines.push_back(fmt::format(
        "reloaded {} in {:.0f} ms (noticed {:.0f}, read {:.0f}, compiled {:.0f}, swapped {:.0f}), "
        "driver {:.0f} ms for {} pipeline{}",
        namesOf(reload.files), times.ownMs(), times.noticeMs, times.readMs, times.compileMs, times.swapMs,
        times.driverMs, reload.pipelines, reload.pipelines == 1 ? "" : "s"));
    return lines;
}

LiveReload::LiveReload(Session& session, std::function<void()> onReady,
                       const std::vector<std::filesystem::path>& written)
    : session_(session), onReady_(std::move(onReady)) {
    watcher_.ignore(written);
    task_ = nextTask(session_.readAt());
    watcher_.watch(task_->files, task_->anything, task_->readAt);  // what is saved from here on counts
    thread_ = std::thread([this] { run(); });
}

LiveReload::~LiveReload() {
    {
        const std::scoped_lock lock(mutex_);
        stop_ = true;
    }
    watcher_.interrupt();
    changed_.notify_all();
    thread_.join();
}

void LiveReload::run() {
    std::optional<Task> task;
    while (takeTask(task)) {
        if (!task->atOnce) task->saved = watcher_.wait();
        if (task->saved.empty() && !task->atOnce) continue;  // interrupted: there may be another task
        work(std::move(*task));
        task.reset();
    }
}

/// Takes the newest task in the place of the one at hand, waiting if there is neither. False: stop.
bool LiveReload::takeTask(std::optional<Task>& task) {
    bool isNew = false;
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return stop_ || task_ || task; });
        if (stop_) return false;
        isNew = task_.has_value();
        if (isNew) task = std::exchange(task_, std::nullopt);
    }
    if (isNew) watcher_.watch(task->files, task->anything, task->readAt);
    if (!std::exchange(isWarm_, true)) task->draft->warmUp();
    return true;
}

void LiveReload::work(Task task) {
    Result result;
    result.reload.files = std::move(task.saved);
    result.reload.times.noticeMs = sinceSaved(result.reload.files);
    result.readAt = FileClock::now();
    result.draft = std::move(task.draft);
    try {
        if (task.anything)
            result.draft->build();  // what was wrong before may be in any of them
        else
            result.draft->buildAfter(result.reload.files);
    } catch (const std::exception& error) {
        result.reload.faults = faultsOf(error);
    }
    result.built = Clock::now();
    {
        const std::scoped_lock lock(mutex_);
        result_ = std::move(result);
    }
    changed_.notify_all();
    if (onReady_) onReady_();
}

bool LiveReload::wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, most, [&] { return result_.has_value(); });
}

std::optional<Reload> LiveReload::poll() {
    std::optional<Result> result;
    {
        const std::scoped_lock lock(mutex_);
        result = std::exchange(result_, std::nullopt);
    }
    if (!result) return std::nullopt;
    Reload& reload = result->reload;
    if (reload.faults.empty() && !adopt(*result)) {
        giveAtOnce(std::move(reload.files), result->readAt);
        return std::nullopt;
    }
    faults_ = reload.faults;
    refused_ = faults_.empty() ? std::vector<std::filesystem::path>() : reload.files;
    give(nextTask(result->readAt, reload.shown ? nullptr : result->draft.get()));
    return std::move(reload);
}

/// False if the session has gone on to something else meanwhile.
bool LiveReload::adopt(Result& result) {
    Reload& reload = result.reload;
    const DraftTimes& built = result.draft->times();
    reload.times.readMs = built.readMs;
    reload.times.compileMs = built.compileMs;
    reload.times.driverMs = built.driverMs;
    reload.pipelines = result.draft->pipelines();
    session_.waitForFrames();
    const Clock::time_point start = Clock::now();
    reload.times.waitMs = milliseconds(start - result.built);
    try {
        if (!session_.adopt(*result.draft)) return false;
        reload.shown = true;
    } catch (const std::exception& error) {
        reload.faults = faultsOf(error);
    }
    reload.times.swapMs = milliseconds(Clock::now() - start);
    return true;
}

LiveReload::Task LiveReload::nextTask(std::filesystem::file_time_type readAt, const Draft* failed) const {
    Task task;
    task.readAt = readAt;
    task.draft = std::make_unique<Draft>(session_.draft(session_.shown()));
    task.files = session_.files();
    if (failed == nullptr && faults_.empty()) return task;
    task.anything = true;
    const auto more = failed == nullptr ? std::vector<std::filesystem::path>() : failed->files();
    task.files.insert(task.files.end(), more.begin(), more.end());
    for (const Diagnostic& fault : faults_) task.files.emplace_back(fault.where.file);
    return task;
}

/// Another attempt at files that were saved.
void LiveReload::giveAtOnce(std::vector<std::filesystem::path> saved,
                            std::filesystem::file_time_type readAt) {
    Task again = nextTask(readAt);
    again.atOnce = true;
    again.saved = std::move(saved);
    give(std::move(again));
}

void LiveReload::tryAgain() {
    if (!refused_.empty()) giveAtOnce(std::exchange(refused_, {}), session_.readAt());
}

void LiveReload::give(Task task) {
    {
        const std::scoped_lock lock(mutex_);
        task_ = std::move(task);
    }
    watcher_.interrupt();
    changed_.notify_all();
}

void LiveReload::watchAnew() {
    give(nextTask(session_.readAt()));
}

}  // namespace nephrite::runtime
