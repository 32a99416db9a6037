// A real Chromium without a window, to open pages in and use them as a reader does.
#pragma once

#include <json/value.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scratch_folder.h"

namespace nephrite::tests {

/// The program, or "" where the distribution has none.
std::filesystem::path findBrowser();

/// One browser with one page. It speaks the DevTools protocol through two pipes, so no port is opened. Throws
/// std::runtime_error: it does not start, does not answer within a minute, or a script fails.
class Browser {
  public:
    Browser(int width, int height);
    ~Browser();
    Browser(const Browser&) = delete;
    Browser& operator=(const Browser&) = delete;

    /// Opens a page and waits until `ready`, an expression, is true.
    void open(const std::filesystem::path& page, const std::string& ready);
    /// The value of an expression in the page.
    Json::Value evaluate(const std::string& expression);
    /// A click in the middle of the first element that matches, as with a mouse.
    void click(const std::string& selector);
    /// A key with a name ("Escape", "Enter") or of one character, pressed and released.
    void press(const std::string& key);
    void type(const std::string& text);
    /// Everything logged as an error or a warning, uncaught exceptions, requests that left the page.
    const std::vector<std::string>& complaints() const { return complaints_; }

  private:
    Json::Value call(const std::string& method, const Json::Value& parameters = Json::objectValue);
    Json::Value receive();
    void note(const Json::Value& event);
    void stop();

    ScratchFolder profile_;
    pid_t process_ = -1;
    int toBrowser_ = -1;
    int fromBrowser_ = -1;
    int lastCall_ = 0;
    std::string session_;
    std::string page_;
    std::string received_;
    std::vector<std::string> complaints_;
};

}  // namespace nephrite::tests
