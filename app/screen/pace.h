// When something on the screen may change: an area of it, and the next frame.
// Threads: plain values on the caller's clock; one thread's.
#pragma once

#include <cstdint>
#include <optional>

namespace touchline {

/// Limits how often an area of the screen changes: two changes a second, so at most one flash a
/// second (accessibility VI-4).
class ChangePace {
  public:
    /// True if a change may be shown now. A single change is shown at once; a third within a second
    /// waits until the first is a second old. `now_ns` never goes back.
    [[nodiscard]] bool may_change(std::int64_t now_ns) const {
        constexpr std::int64_t second_ns = 1'000'000'000;
        return !before_last_ns_ || now_ns - *before_last_ns_ >= second_ns;
    }

    /// True if there was any change at all.
    [[nodiscard]] bool has_changed() const { return last_ns_.has_value(); }

    void changed(std::int64_t now_ns) {
        before_last_ns_ = last_ns_;
        last_ns_ = now_ns;
    }

  private:
    std::optional<std::int64_t> last_ns_;
    std::optional<std::int64_t> before_last_ns_;
};

/// Tells when the next frame is due. Software OpenGL does not wait for the screen, so the kiosk has
/// its own limit; it never spins. Frames lie on a fixed grid, so rounding errors do not add up. A
/// frame that takes too long skips whole periods, and no burst follows.
class FrameLimiter {
  public:
    /// Frame 0 is due at `start_ns`. 1 <= rate_Hz <= 1000.
    FrameLimiter(std::int64_t start_ns, int rate_Hz) : start_ns_(start_ns), rate_Hz_(rate_Hz) {}

    /// Reports that a frame was finished at `now_ns`, which never goes back. Returns when the next
    /// one is due, always later than now.
    [[nodiscard]] std::int64_t finish_frame(std::int64_t now_ns);

    /// How many frames were finished.
    [[nodiscard]] std::int64_t frames() const { return frames_; }

    /// How many places on the grid were skipped.
    [[nodiscard]] std::int64_t skipped() const { return skipped_; }

  private:
    [[nodiscard]] std::int64_t due_ns(std::int64_t place) const;

    std::int64_t start_ns_;
    std::int64_t rate_Hz_;
    std::int64_t place_ = 0;  // the current frame's place on the grid
    std::int64_t frames_ = 0;
    std::int64_t skipped_ = 0;
};

}  // namespace touchline
