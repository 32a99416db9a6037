// A screen of a test's own (Xvfb with the window manager openbox), and a hand on its mouse.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

struct _XDisplay;

namespace nephrite::view::test {

/// A program that was started; ended with the object.
class Process {
  public:
    explicit Process(std::vector<std::string> command);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

  private:
    pid_t id_ = -1;
};

class Screen {
  public:
    /// Whether this machine has what a screen is made of.
    static bool isAvailable();
    /// Points $DISPLAY to it. Throws std::runtime_error if it does not start.
    Screen();
    ~Screen();
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    /// The window whose title ends so; 0 if there is none.
    unsigned long windowNamed(const std::string& ending) const;
    /// Drags the left button from one place of a window to another, in pixels.
    void drag(unsigned long window, int fromX, int fromY, int toX, int toY) const;
    void doubleClick(unsigned long window, int x, int y) const;
    void wheel(unsigned long window, int x, int y, int steps) const;
    void resize(unsigned long window, unsigned width, unsigned height) const;
    void minimise(unsigned long window) const;
    void restore(unsigned long window) const;
    /// As the button in the window's corner does.
    void close(unsigned long window) const;

  private:
    void move(unsigned long window, int x, int y) const;
    void press(unsigned button, bool down) const;

    std::unique_ptr<Process> server_;
    std::unique_ptr<Process> manager_;
    _XDisplay* display_ = nullptr;
};

}  // namespace nephrite::view::test
