// GLFW behind a class.
#define GLFW_INCLUDE_VULKAN
#include "view/window.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "gpu/result.h"
#include "text/diagnostics.h"

namespace nephrite::view {
namespace {

/// What the library says of its last failure.
std::string lastFailure() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason given" : text;
}

}  // namespace

WindowLibrary::WindowLibrary() {
    if (glfwInit() != GLFW_TRUE)
        throw RunError(
            fmt::format("cannot open a window: {} (is there a screen? DISPLAY or WAYLAND_DISPLAY names it)",
                        lastFailure()));
    if (glfwVulkanSupported() == GLFW_TRUE) return;
    glfwTerminate();
    throw RunError("cannot open a window: there is no Vulkan driver for this screen");
}

WindowLibrary::~WindowLibrary() {
    glfwTerminate();
}

gpu::Presentation WindowLibrary::presentation() const {
    gpu::Presentation presentation;
    std::uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr) throw RunError(fmt::format("cannot open a window: {}", lastFailure()));
    presentation.instanceExtensions.assign(names, names + count);
    presentation.isSupported = [](VkInstance instance, VkPhysicalDevice device, std::uint32_t family) {
        return glfwGetPhysicalDevicePresentationSupport(instance, device, family) == GLFW_TRUE;
    };
    return presentation;
}

Window::Window(const WindowLibrary&, const std::string& title, int width, int height) {
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "nephrite");
    window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) throw RunError(fmt::format("cannot open a window: {}", lastFailure()));
    glfwSetWindowSizeLimits(window_, leastWindowWidth, leastWindowHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    listen();
}

Window::~Window() {
    glfwDestroyWindow(window_);
}

void Window::noteActivity(GLFWwindow* window) {
    static_cast<Window*>(glfwGetWindowUserPointer(window))->active_ = true;
}

/// Who listens later is expected to call these in turn.
void Window::listen() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int, int, int, int) { noteActivity(window); });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned) { noteActivity(window); });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int, int, int) { noteActivity(window); });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { noteActivity(window); });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double, double) { noteActivity(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { noteActivity(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { noteActivity(window); });
    glfwSetWindowIconifyCallback(window_, [](GLFWwindow* window, int) { noteActivity(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { noteActivity(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { noteActivity(window); });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { noteActivity(window); });
}

gpu::Surface Window::makeSurface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    gpu::check(glfwCreateWindowSurface(instance, window_, nullptr, &surface), "cannot draw in the window");
    return {instance, surface};
}

VkExtent2D Window::pixels() const {
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) return {0, 0};
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

float Window::contentScale() const {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return y > 0 ? y : 1;
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

bool Window::takeCloseRequest() {
    const bool isAsked = glfwWindowShouldClose(window_) == GLFW_TRUE;
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return isAsked;
}

void Window::wait(double seconds) {
    glfwWaitEventsTimeout(seconds);
}

void Window::poll() {
    glfwPollEvents();
}

void Window::wake() {
    glfwPostEmptyEvent();
}

bool Window::takeActivity() {
    const bool active = active_;
    active_ = false;
    return active;
}

}  // namespace nephrite::view
