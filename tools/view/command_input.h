// Commands that come as lines from a file, a pipe or standard input while the window is open.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "text/file_descriptor.h"

namespace nephrite::view {

class CommandInput {
  public:
    /// "-" is standard input. `onLine` is called from another thread when next() has something. Throws
    /// InputError if the file cannot be read.
    CommandInput(const std::filesystem::path& file, std::function<void()> onLine);
    ~CommandInput();
    CommandInput(const CommandInput&) = delete;
    CommandInput& operator=(const CommandInput&) = delete;

    /// The next line, if one has come.
    std::optional<std::string> next();
    bool hasNext() const;

  private:
    void read();
    void give(std::string line);

    std::function<void()> onLine_;
    FileDescriptor input_;
    FileDescriptor stop_;  ///< readable when the thread shall end
    mutable std::mutex mutex_;
    std::deque<std::string> lines_;  ///< guarded by mutex_
    std::thread thread_;
};

}  // namespace nephrite::view
