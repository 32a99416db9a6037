// A window of the desktop that Vulkan draws in, and whether its user has done anything.
#pragma once

#include <string>

#include "gpu/presentation.h"
#include "gpu/surface.h"

struct GLFWwindow;

namespace nephrite::view {

/// Smaller than this, in the desktop's units, the controls have no room.
constexpr int leastWindowWidth = 640;
constexpr int leastWindowHeight = 480;

/// The window library, in use as long as this lives. One at a time.
class WindowLibrary {
  public:
    /// Throws RunError if there is no screen or no Vulkan for it.
    WindowLibrary();
    ~WindowLibrary();
    WindowLibrary(const WindowLibrary&) = delete;
    WindowLibrary& operator=(const WindowLibrary&) = delete;

    gpu::Presentation presentation() const;
};

class Window {
  public:
    /// `width` and `height` are in the desktop's units. Throws RunError.
    Window(const WindowLibrary& library, const std::string& title, int width, int height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() const { return window_; }
    /// Throws RunError.
    gpu::Surface makeSurface(VkInstance instance) const;
    /// Pixels to draw; 0 x 0 while it is minimised.
    VkExtent2D pixels() const;
    /// How much larger than usual the desktop wants letters.
    float contentScale() const;
    void setTitle(const std::string& title);

    /// Whether the desktop has asked to close it since the last call.
    bool takeCloseRequest();

    /// Sleeps until something happens to the window, wake() is called or so many seconds have passed.
    void wait(double seconds);
    /// Takes note of what has happened to the window, without waiting.
    void poll();
    /// Ends wait(). From any thread.
    static void wake();
    /// Whether its user has done anything, or it has to be drawn anew, since the last call.
    bool takeActivity();

  private:
    static void noteActivity(GLFWwindow* window);
    void listen();

    GLFWwindow* window_ = nullptr;
    bool active_ = true;
};

}  // namespace nephrite::view
