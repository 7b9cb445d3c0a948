#include "app/screen/window.h"

#include "config/types/steady_clock.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <epoxy/gl.h>
// Before GLFW, because epoxy declares OpenGL itself.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace touchline {

namespace {

// Any smaller, and no word could be read.
constexpr int least_width = 480;
constexpr int least_height = 320;

constexpr std::array named_keys{std::pair{GLFW_KEY_LEFT, Key::left},
                                std::pair{GLFW_KEY_RIGHT, Key::right},
                                std::pair{GLFW_KEY_UP, Key::up},
                                std::pair{GLFW_KEY_DOWN, Key::down},
                                std::pair{GLFW_KEY_PAGE_UP, Key::page_up},
                                std::pair{GLFW_KEY_PAGE_DOWN, Key::page_down},
                                std::pair{GLFW_KEY_ESCAPE, Key::escape},
                                std::pair{GLFW_KEY_ENTER, Key::enter},
                                std::pair{GLFW_KEY_KP_ENTER, Key::enter},
                                std::pair{GLFW_KEY_TAB, Key::tab},
                                std::pair{GLFW_KEY_BACKSPACE, Key::backspace},
                                std::pair{GLFW_KEY_INSERT, Key::insert},
                                std::pair{GLFW_KEY_DELETE, Key::remove},
                                std::pair{GLFW_KEY_HOME, Key::home},
                                std::pair{GLFW_KEY_END, Key::end}};

/// GLFW names printing keys by their upper-case ASCII character, as Key does. Its scancode tells a
/// key without such a name.
PhysicalKey key_of(int glfw_key, int scancode) {
    const auto named = [](Key key) {
        return PhysicalKey{KeySource::key, static_cast<std::uint32_t>(key)};
    };
    for (const auto& [code, key] : named_keys)
        if (code == glfw_key) return named(key);
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F24)
        return named(Key{static_cast<std::uint32_t>(Key::f1) +
                         static_cast<std::uint32_t>(glfw_key - GLFW_KEY_F1)});
    constexpr int last_printing = 126;
    if (glfw_key > 0 && glfw_key <= last_printing)
        return named(Key{static_cast<std::uint32_t>(glfw_key)});
    return {KeySource::scancode, static_cast<std::uint32_t>(std::max(scancode, 0))};
}

/// GLFW's reason for its last failure.
std::string glfw_reason() {
    const char* words = nullptr;
    glfwGetError(&words);
    return words != nullptr ? words : "no reason given";
}

/// The place of a monitor or the window on the whole display.
struct DisplayPlace {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const DisplayPlace&, const DisplayPlace&) = default;
};

/// Null without a monitor.
const GLFWvidmode* mode_of(GLFWmonitor* monitor) {
    return monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
}

/// Nothing while there is no monitor that shows anything.
std::optional<DisplayPlace> place_of_monitor() {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = mode_of(monitor);
    if (mode == nullptr || mode->width <= 0 || mode->height <= 0) return std::nullopt;
    DisplayPlace place{0, 0, mode->width, mode->height};
    glfwGetMonitorPos(monitor, &place.x, &place.y);
    return place;
}

DisplayPlace place_of(GLFWwindow* window) {
    DisplayPlace place;
    glfwGetWindowPos(window, &place.x, &place.y);
    glfwGetWindowSize(window, &place.width, &place.height);
    return place;
}

GLFWwindow* create_window(bool is_full_screen) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    GLFWmonitor* const monitor = is_full_screen ? glfwGetPrimaryMonitor() : nullptr;
    const GLFWvidmode* const mode = mode_of(monitor);
    const int width = mode != nullptr ? mode->width : 1280;
    const int height = mode != nullptr ? mode->height : 800;
    return glfwCreateWindow(width, height, "Touchline", mode != nullptr ? monitor : nullptr,
                            nullptr);
}

}  // namespace

std::int64_t now_ns() {
    return steady_now_ns();
}

Result<std::unique_ptr<Window>> Window::open(bool is_full_screen, Listener listener) {
#ifdef GLFW_PLATFORM  // 3.4 (Debian 13) would choose Wayland, which numbers keys differently
    glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (glfwInit() != GLFW_TRUE)
        return failure(fmt::format("no window: {}; start it on a display, or use touchline tour",
                                   glfw_reason()));
    GLFWwindow* const window = create_window(is_full_screen);
    if (window == nullptr) {
        const std::string reason = glfw_reason();
        glfwTerminate();
        return failure(fmt::format("no window: {}; OpenGL 2.1 is needed", reason));
    }
    return std::unique_ptr<Window>(new Window(window, is_full_screen, std::move(listener)));
}

Window::Window(GLFWwindow* window, bool is_full_screen, Listener listener)
    : window_(window), is_full_screen_(is_full_screen), listener_(std::move(listener)) {
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetWindowSizeLimits(window_, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->update_size();
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->is_exposed_ = true;
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int scancode, int action, int) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))
            ->listener_.key_changed(key_of(key, scancode), action != GLFW_RELEASE,
                                    action == GLFW_REPEAT);
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        const auto* const self = static_cast<Window*>(glfwGetWindowUserPointer(w));
        if (const auto place = self->in_pixels(x, y)) self->listener_.pointer_moved(*place);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        if (button != GLFW_MOUSE_BUTTON_LEFT && button != GLFW_MOUSE_BUTTON_RIGHT) return;
        const auto* const self = static_cast<Window*>(glfwGetWindowUserPointer(w));
        double x = 0.0;
        double y = 0.0;
        glfwGetCursorPos(w, &x, &y);
        if (const auto place = self->in_pixels(x, y))
            self->listener_.pointer_pressed(
                {*place, action == GLFW_PRESS, button == GLFW_MOUSE_BUTTON_RIGHT});
    });
    if (is_full_screen_) glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    update_size();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::update_size() {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    width_px_ = std::max(width, 1);
    height_px_ = std::max(height, 1);
}

/// The pointer's unit may be several pixels.
std::optional<PixelPoint> Window::in_pixels(double x, double y) const {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (width <= 0 || height <= 0) return std::nullopt;
    return PixelPoint{x * width_px_ / width, y * height_px_ / height};
}

void Window::show_pointer(bool is_shown) {
    if (!is_full_screen_ || is_shown == is_pointer_shown_) return;
    is_pointer_shown_ = is_shown;
    glfwSetInputMode(window_, GLFW_CURSOR, is_shown ? GLFW_CURSOR_NORMAL : GLFW_CURSOR_HIDDEN);
}

/// A window manager lets a full-screen window follow its monitor; without one GLFW leaves it as it
/// was. The window then becomes one without borders over the whole monitor. To be full screen
/// again, in GLFW's sense, it would have to set one of the modes that GLFW knew at the start.
void Window::follow_monitor() {
    constexpr std::int64_t every_ns = 250'000'000;
    const std::int64_t time_ns = now_ns();
    if (!is_full_screen_ || time_ns < next_look_ns_) return;
    next_look_ns_ = time_ns + every_ns;
    const auto monitor = place_of_monitor();
    const bool is_covered = !monitor || *monitor == place_of(window_);
    // Acts only at the second check, after the window manager had its time.
    if (!is_covered && !was_covered_) {
        glfwSetWindowAttrib(window_, GLFW_DECORATED, GLFW_FALSE);
        glfwSetWindowMonitor(window_, nullptr, monitor->x, monitor->y, monitor->width,
                             monitor->height, GLFW_DONT_CARE);
    }
    was_covered_ = is_covered;
}

double Window::mm_per_px() const {
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* const mode = mode_of(monitor);
    if (mode == nullptr || mode->width <= 0) return 0.0;
    int width_mm = 0;
    int height_mm = 0;
    glfwGetMonitorPhysicalSize(monitor, &width_mm, &height_mm);
    return static_cast<double>(width_mm) / mode->width;
}

bool Window::is_closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::show_frame() {
    glfwSwapBuffers(window_);
}

/// Reads the first joystick: a switch interface or a large button counts as one.
void Window::read_joysticks() {
    int count = 0;
    const unsigned char* const down = glfwGetJoystickButtons(GLFW_JOYSTICK_1, &count);
    const auto buttons = down != nullptr ? static_cast<std::size_t>(count) : 0U;
    buttons_.resize(std::max(buttons_.size(), buttons), false);
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        const bool is_down = i < buttons && down[i] == GLFW_PRESS;
        if (is_down == buttons_[i]) continue;
        buttons_[i] = is_down;
        listener_.key_changed({KeySource::joystick, static_cast<std::uint32_t>(i)}, is_down, false);
    }
}

void Window::read_knob() {
    int count = 0;
    const float* const axes = glfwGetJoystickAxes(GLFW_JOYSTICK_1, &count);
    const bool is_there = axes != nullptr && count > 0;
    const double turned_rad = knob_.step(is_there ? std::optional(double{axes[0]}) : std::nullopt);
    if (turned_rad != 0.0) listener_.knob_turned(turned_rad);
}

void Window::wait_until(std::int64_t due_ns) {
    glfwPollEvents();
    follow_monitor();
    read_joysticks();
    read_knob();
    for (std::int64_t left_ns = due_ns - now_ns(); left_ns > 0; left_ns = due_ns - now_ns())
        glfwWaitEventsTimeout(static_cast<double>(left_ns) * 1e-9);
}

}  // namespace touchline
