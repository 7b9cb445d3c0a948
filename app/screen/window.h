// The kiosk's window: GLFW, an OpenGL context, keys, the pointer and the knob of a joystick.
// Threads: the main thread only, as GLFW demands. One window at a time.
#pragma once

#include "app/screen/layout.h"
#include "config/settings/keys.h"
#include "config/types/pinned.h"
#include "config/types/result.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace touchline {

/// A knob on a joystick: an axis whose whole range is one turn. A plain value.
class Knob {
  public:
    /// Returns how far it turned since it last moved, counter-clockwise; the axis is -1 ... 1,
    /// clockwise. An endless knob wraps around. Returns 0 for a missing axis, for the first value
    /// after it comes back, and for noise.
    [[nodiscard]] double step(std::optional<double> axis) {
        constexpr double noise = 0.004;  // one count of 8 bits is 0.008
        const double now = axis.value_or(nowhere);
        const double turned = std::remainder(now - last_, 2.0);
        if (std::abs(turned) < noise) return 0.0;
        last_ = now;
        return std::isfinite(turned) ? -std::numbers::pi * turned : 0.0;
    }

  private:
    static constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

    double last_ = nowhere;
};

/// The present time of Window::wait_until()'s clock (the steady clock).
[[nodiscard]] std::int64_t now_ns();

/// A button of the pointer went down or up. A pen's tip is the first button, the button on its side
/// the second.
struct PointerPress {
    PixelPoint place;
    bool is_down = false;
    bool is_second = false;
};

class Window : private Pinned {
  public:
    /// wait_until() calls these as things happen.
    struct Listener {
        std::function<void(const PhysicalKey&, bool is_down, bool is_repeat)> key_changed;
        std::function<void(PixelPoint)> pointer_moved;
        std::function<void(const PointerPress&)> pointer_pressed;
        std::function<void(double by_rad)> knob_turned;  // counter-clockwise
    };

    /// Opens a full-screen window on the first monitor, which it follows through changes of mode
    /// and of monitor, or a window of 1280 x 800. Fails if there is no display or no OpenGL 2.1.
    [[nodiscard]] static Result<std::unique_ptr<Window>> open(bool is_full_screen,
                                                              Listener listener);
    ~Window();

    /// The size of the drawable, in pixels; >= 1.
    [[nodiscard]] int width_px() const { return width_px_; }

    [[nodiscard]] int height_px() const { return height_px_; }

    /// The size of a pixel as the monitor reports it; 0 if it does not.
    [[nodiscard]] double mm_per_px() const;

    /// True if the person at the window system asked to close it.
    [[nodiscard]] bool is_closing() const;

    /// Shows or hides the pointer's arrow over a full-screen window, which begins without.
    void show_pointer(bool is_shown);

    /// Shows what was drawn.
    void show_frame();

    /// True if the display lost what was shown since the last call.
    [[nodiscard]] bool take_exposed() { return std::exchange(is_exposed_, false); }

    /// Sleeps until `due_ns`, handling keys and pointer as they come, at least once.
    void wait_until(std::int64_t due_ns);

  private:
    Window(GLFWwindow* window, bool is_full_screen, Listener listener);

    void update_size();
    [[nodiscard]] std::optional<PixelPoint> in_pixels(double x, double y) const;
    void follow_monitor();
    void read_joysticks();
    void read_knob();

    GLFWwindow* window_;
    bool is_full_screen_;
    Listener listener_;
    int width_px_ = 1;
    int height_px_ = 1;
    std::vector<bool> buttons_;      // the joystick's: is it down?
    Knob knob_;                      // the joystick's first axis
    std::int64_t next_look_ns_ = 0;  // when to check the monitor again
    bool is_pointer_shown_ = false;
    bool is_exposed_ = false;  // since somebody asked
    bool was_covered_ = true;  // the window covered the monitor at the last check
};

}  // namespace touchline
