// Tells when the next frame is due. Software OpenGL does not wait for the screen, so the kiosk has
// its own limit; it never spins. Threads: one, the screen's. A pure value on the caller's clock.
#pragma once

#include <cstdint>

namespace touchline {

/// Frames lie on a fixed grid, so rounding errors do not add up. A frame that takes too long skips
/// whole periods, and no burst follows.
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
