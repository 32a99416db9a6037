// Starting the screen, and events sent to it with the XTest extension.
#include "screen.h"

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

namespace nephrite::view::test {
namespace {

using namespace std::chrono_literals;

std::string titleOf(Display* display, Window window) {
    char* name = nullptr;
    if (XFetchName(display, window, &name) == 0 || name == nullptr) return {};
    const std::string title = name;
    XFree(name);
    return title;
}

Window findNamed(Display* display, const std::string& ending) {
    std::vector<Window> open{DefaultRootWindow(display)};
    while (!open.empty()) {
        const Window window = open.back();
        open.pop_back();
        if (titleOf(display, window).ends_with(ending)) return window;
        Window root = 0, parent = 0;
        Window* children = nullptr;
        unsigned count = 0;
        if (XQueryTree(display, window, &root, &parent, &children, &count) == 0) continue;
        open.insert(open.end(), children, children + count);
        if (children != nullptr) XFree(children);
    }
    return 0;
}

/// A window that comes while the manager starts may be overlooked by it, and GLFW then waits for it for ever.
void waitForManager(Display* display) {
    const Atom property = XInternAtom(display, "_NET_SUPPORTING_WM_CHECK", False);
    for (int i = 0; i < 200; ++i) {
        Atom type = None;
        int format = 0;
        unsigned long count = 0, left = 0;
        unsigned char* value = nullptr;
        XGetWindowProperty(display, DefaultRootWindow(display), property, 0, 1, False, AnyPropertyType, &type,
                           &format, &count, &left, &value);
        if (value != nullptr) XFree(value);
        if (type != None) return;
        std::this_thread::sleep_for(50ms);
    }
    throw std::runtime_error("openbox does not start");
}

}  // namespace

Process::Process(std::vector<std::string> command) {
    std::vector<char*> words;
    for (std::string& word : command) words.push_back(word.data());
    words.push_back(nullptr);
    id_ = fork();
    if (id_ != 0) return;
    if (std::freopen("/dev/null", "w", stderr) != nullptr) execvp(words[0], words.data());
    _exit(127);
}

Process::~Process() {
    if (id_ <= 0) return;
    kill(id_, SIGTERM);
    waitpid(id_, nullptr, 0);
}

bool Screen::isAvailable() {
    return std::filesystem::exists("/usr/bin/Xvfb") && std::filesystem::exists("/usr/bin/openbox");
}

Screen::Screen() {
    const std::string name = ":" + std::to_string(100 + getpid() % 20000);
    setenv("DISPLAY", name.c_str(), 1);
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", name, "-screen", "0", "1400x1000x24", "-nolisten", "tcp"});
    for (int i = 0; i < 200 && display_ == nullptr; ++i) {
        std::this_thread::sleep_for(50ms);
        display_ = XOpenDisplay(name.c_str());
    }
    if (display_ == nullptr) throw std::runtime_error("Xvfb does not start");
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });  // windows come and go while one looks
    manager_ = std::make_unique<Process>(std::vector<std::string>{"openbox"});
    waitForManager(display_);
}

Screen::~Screen() {
    if (display_ != nullptr) XCloseDisplay(display_);
}

unsigned long Screen::windowNamed(const std::string& ending) const {
    for (int i = 0; i < 1600; ++i) {
        if (const Window window = findNamed(display_, ending)) return window;
        std::this_thread::sleep_for(50ms);
    }
    return 0;
}

void Screen::move(unsigned long window, int x, int y) const {
    Window child = 0;
    int rootX = 0, rootY = 0;
    XTranslateCoordinates(display_, window, DefaultRootWindow(display_), x, y, &rootX, &rootY, &child);
    XTestFakeMotionEvent(display_, -1, rootX, rootY, CurrentTime);
    XSync(display_, False);
    std::this_thread::sleep_for(60ms);
}

void Screen::press(unsigned button, bool down) const {
    XTestFakeButtonEvent(display_, button, down ? True : False, CurrentTime);
    XSync(display_, False);
    std::this_thread::sleep_for(60ms);
}

void Screen::drag(unsigned long window, int fromX, int fromY, int toX, int toY) const {
    constexpr int steps = 6;
    move(window, fromX, fromY);
    press(1, true);
    for (int i = 1; i <= steps; ++i)
        move(window, fromX + (toX - fromX) * i / steps, fromY + (toY - fromY) * i / steps);
    press(1, false);
}

void Screen::doubleClick(unsigned long window, int x, int y) const {
    move(window, x, y);
    for (int i = 0; i < 2; ++i) {
        press(1, true);
        press(1, false);
    }
}

void Screen::wheel(unsigned long window, int x, int y, int steps) const {
    constexpr unsigned up = 4, down = 5;
    move(window, x, y);
    for (int i = 0; i < std::abs(steps); ++i) {
        press(steps > 0 ? up : down, true);
        press(steps > 0 ? up : down, false);
    }
}

void Screen::resize(unsigned long window, unsigned width, unsigned height) const {
    XResizeWindow(display_, window, width, height);
    XSync(display_, False);
}

void Screen::minimise(unsigned long window) const {
    XIconifyWindow(display_, window, DefaultScreen(display_));
    XSync(display_, False);
}

void Screen::restore(unsigned long window) const {
    XMapWindow(display_, window);
    XSync(display_, False);
}

void Screen::close(unsigned long window) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
    XSendEvent(display_, window, False, NoEventMask, &event);
    XSync(display_, False);
}

}  // namespace nephrite::view::test
