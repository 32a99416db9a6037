// See browser.h.
#include "browser/browser.h"

#include <fcntl.h>
#include <json/reader.h>
#include <json/writer.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace nephrite::tests {
namespace {

constexpr std::chrono::seconds patience{60};
// Where Chromium's --remote-debugging-pipe reads and writes.
constexpr int browserReads = 3;
constexpr int browserWrites = 4;

/// Both ends of a pipe that no other child inherits, away from the numbers given to the browser.
std::array<int, 2> makePipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    for (int& end : ends) {
        const int moved = ::fcntl(end, F_DUPFD_CLOEXEC, 16);
        ::close(end);
        end = moved;
    }
    return ends;
}

pid_t startBrowser(const std::filesystem::path& profile, int readEnd, int writeEnd) {
    std::vector<std::string> arguments{findBrowser().string(),
                                       "--headless",
                                       "--remote-debugging-pipe",
                                       "--disable-gpu",
                                       "--disable-extensions",
                                       "--no-first-run",
                                       "--disable-background-networking",
                                       "--disable-component-update",
                                       "--user-data-dir=" + profile.string()};
    if (::geteuid() == 0) arguments.emplace_back("--no-sandbox");  // it refuses to run as root with it
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, readEnd, browserReads);
    posix_spawn_file_actions_adddup2(&actions, writeEnd, browserWrites);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    const int failure = ::posix_spawn(&process, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) throw std::runtime_error("the browser does not start");
    return process;
}

Json::Value object(std::initializer_list<std::pair<const char*, Json::Value>> members) {
    Json::Value value(Json::objectValue);
    for (const auto& [name, member] : members) value[name] = member;
    return value;
}

}  // namespace

std::filesystem::path findBrowser() {
    for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser"})
        if (std::filesystem::exists(path)) return path;
    return {};
}

Browser::Browser(int width, int height) {
    const auto [readEnd, toBrowser] = makePipe();
    const auto [fromBrowser, writeEnd] = makePipe();
    toBrowser_ = toBrowser;
    fromBrowser_ = fromBrowser;
    process_ = startBrowser(profile_.path(), readEnd, writeEnd);
    ::close(readEnd);
    ::close(writeEnd);
    try {
        const std::string target =
            call("Target.createTarget", object({{"url", "about:blank"}}))["targetId"].asString();
        session_ =
            call("Target.attachToTarget", object({{"targetId", target}, {"flatten", true}}))["sessionId"]
                .asString();
        for (const char* domain : {"Runtime", "Log", "Page", "Network"})
            call(std::string(domain) + ".enable");
        call("Emulation.setDeviceMetricsOverride",
             object({{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}}));
    } catch (...) {
        stop();
        throw;
    }
}

Browser::~Browser() {
    stop();
}

void Browser::stop() {
    ::close(toBrowser_);  // at which it ends by itself
    ::close(fromBrowser_);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (::waitpid(process_, nullptr, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) ::kill(process_, SIGKILL);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

Json::Value Browser::call(const std::string& method, const Json::Value& parameters) {
    Json::Value message = object({{"id", ++lastCall_}, {"method", method}, {"params", parameters}});
    if (!session_.empty()) message["sessionId"] = session_;
    const std::string text = Json::writeString(Json::StreamWriterBuilder(), message) + '\0';
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t count = ::write(toBrowser_, text.data() + sent, text.size() - sent);
        if (count < 0) throw std::runtime_error("the browser has gone");
        sent += static_cast<std::size_t>(count);
    }
    while (true) {
        const Json::Value answer = receive();
        if (answer.isMember("method")) note(answer);
        if (answer["id"] != lastCall_) continue;
        if (answer.isMember("error"))
            throw std::runtime_error(method + ": " + answer["error"]["message"].asString());
        return answer["result"];
    }
}

Json::Value Browser::receive() {
    std::size_t end = received_.find('\0');
    while (end == std::string::npos) {
        pollfd wait{fromBrowser_, POLLIN, 0};
        const int ready = ::poll(&wait, 1, static_cast<int>(std::chrono::milliseconds(patience).count()));
        std::array<char, 65536> block{};
        const ssize_t count = ready > 0 ? ::read(fromBrowser_, block.data(), block.size()) : 0;
        if (count <= 0) throw std::runtime_error("the browser does not answer");
        received_.append(block.data(), static_cast<std::size_t>(count));
        end = received_.find('\0');
    }
    std::istringstream stream(received_.substr(0, end));
    received_.erase(0, end + 1);
    Json::Value message;
    stream >> message;
    return message;
}

void Browser::note(const Json::Value& event) {
    const std::string method = event["method"].asString();
    const Json::Value& parameters = event["params"];
    if (method == "Runtime.exceptionThrown")
        complaints_.push_back(parameters["exceptionDetails"]["exception"]["description"].asString());
    if (method == "Log.entryAdded") complaints_.push_back(parameters["entry"]["text"].asString());
    if (method == "Runtime.consoleAPICalled" && parameters["type"] != "log")
        complaints_.push_back(parameters["args"][0]["value"].asString());
    if (method == "Network.requestWillBeSent") {
        const std::string url = parameters["request"]["url"].asString();
        if (url != page_ && !url.starts_with("data:")) complaints_.push_back("asks for " + url);
    }
}

void Browser::open(const std::filesystem::path& page, const std::string& ready) {
    page_ = "file://" + page.string();
    call("Page.navigate", object({{"url", page_}}));
    const auto end = std::chrono::steady_clock::now() + patience;
    while (!evaluate(ready).asBool()) {
        if (std::chrono::steady_clock::now() > end)
            throw std::runtime_error("the page does not become ready");
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

Json::Value Browser::evaluate(const std::string& expression) {
    const Json::Value answer =
        call("Runtime.evaluate", object({{"expression", expression}, {"returnByValue", true}}));
    if (answer.isMember("exceptionDetails"))
        throw std::runtime_error(expression + ": " +
                                 answer["exceptionDetails"]["exception"]["description"].asString());
    return answer["result"]["value"];
}

void Browser::click(const std::string& selector) {
    const Json::Value box = evaluate("(() => { const box = document.querySelector(" +
                                     std::string(Json::valueToQuotedString(selector.c_str())) +
                                     ").getBoundingClientRect(); return [box.x + box.width / 2, box.y + "
                                     "box.height / 2]; })()");
    for (const char* type : {"mousePressed", "mouseReleased"})
        call("Input.dispatchMouseEvent",
             object({{"type", type}, {"x", box[0]}, {"y", box[1]}, {"button", "left"}, {"clickCount", 1}}));
}

void Browser::press(const std::string& key) {
    Json::Value down = object({{"type", "keyDown"}, {"key", key}});
    if (key.size() == 1) down["text"] = key;
    call("Input.dispatchKeyEvent", down);
    call("Input.dispatchKeyEvent", object({{"type", "keyUp"}, {"key", key}}));
}

void Browser::type(const std::string& text) {
    call("Input.insertText", object({{"text", text}}));
}

}  // namespace nephrite::tests
