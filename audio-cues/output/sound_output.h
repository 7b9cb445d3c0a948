// Connects the mixer to a device that may be missing, lost or busy, and tells which frame sounds at
// which time. Threads: one, and the device's.
#pragma once

#include "audio-cues/synth/frames.h"
#include "audio-cues/synth/limiter.h"
#include "audio-cues/synth/mixer.h"
#include "config/types/pinned.h"
#include "config/types/result.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace touchline {

/// Fills all the frames at once.
using FrameSource = std::function<void(std::span<StereoFrame>)>;

/// What a device asks for at once while nobody is here; 10.7 ms. It wakes a processor a quarter as
/// often. The first key is heard later for it: by 8 ms, and by 16 more where a card holds two.
inline constexpr int resting_block_frames = 4 * block_frames;

/// Where frames go: the one interface of sound, so that tests need no card. Threads: all calls from
/// one; the source is called from the device's.
class SoundDevice : public Interface {
  public:
    /// The device must be closed before. From here on it asks `source` for frames, `block` at a
    /// time, a power of two. Fails with one line if there is no device or it is in use.
    [[nodiscard]] virtual Result<void> open(FrameSource source, int block) = 0;

    /// Returns once the source is not being asked any more. The device may be closed already.
    virtual void close() = 0;

    /// True if it is open but unplugged, as the system reports.
    [[nodiscard]] virtual bool is_gone() const = 0;
};

/// The environment's SDL_AUDIODRIVER chooses the driver (in tests `dummy` and `disk`). Installs no
/// signal handler and needs no window.
class SdlDevice final : public SoundDevice {
  public:
    ~SdlDevice() override { close(); }

    [[nodiscard]] Result<void> open(FrameSource source, int block) override;
    void close() override;
    [[nodiscard]] bool is_gone() const override;

  private:
    static void fill(void* device, std::uint8_t* bytes, int count);

    FrameSource source_;
    std::uint32_t id_ = 0;  // 0: closed
};

/// Smooths the times it is told, because two clocks drift and a device asks in bursts; so sounds
/// keep the times between them.
class FrameClock {
  public:
    /// Tells the clock that the mixer is about to render `frame`, at `now_ns` of the monotonic
    /// clock.
    void told(FrameTime frame, std::int64_t now_ns);

    /// Forgets all it was told, when the device begins anew.
    void forget() { start_ns_.store(nothing, std::memory_order_relaxed); }

    /// Returns the frame to stamp an event at `time_ns` with. It has not been rendered yet, and is
    /// heard one block after the mixer was at that time: the limiter adds the rest of that block.
    /// Returns 0, which means now, before told() was called.
    [[nodiscard]] FrameTime frame_at(std::int64_t time_ns) const;

    static constexpr int lead_frames = block_frames - Limiter::look_ahead_frames;

  private:
    static constexpr std::int64_t nothing = INT64_MIN;
    std::atomic<std::int64_t> start_ns_{nothing};  // when frame 0 would have been
};

class SoundOutput : private Pinned {
  public:
    /// The mixer must outlive the output. The constructor opens nothing. `clock_ns` is the
    /// monotonic clock.
    SoundOutput(std::unique_ptr<SoundDevice> device, Mixer& mixer,
                std::function<std::int64_t()> clock_ns);

    ~SoundOutput() { device_->close(); }

    /// Call often, such as 60 times a second. Opens the device; closes it if it is gone or asked
    /// for nothing during stall_s, and tries again every retry_s. Meanwhile the mixer renders to
    /// nowhere at its usual pace, so that speech comes to its ends and everything else goes on.
    void step();

    /// Whether nobody is here, so that the device may ask for resting_block_frames at once. It is
    /// opened anew for that, and again when somebody comes, each time after a second without a
    /// sound: nothing that is heard has a gap or waits.
    void rest(bool is_nobody_here);

    /// True if a device plays. The screen says so if none does.
    [[nodiscard]] bool is_working() const { return is_open_; }

    /// Why no device plays; empty if one does.
    [[nodiscard]] const std::string& problem() const { return problem_; }

    /// The clock for time stamps of commands.
    [[nodiscard]] const FrameClock& clock() const { return frame_clock_; }

    static constexpr double stall_s = 0.5;
    static constexpr double retry_s = 2.0;

  private:
    void open(std::int64_t now_ns);
    void lose(std::int64_t now_ns, std::string problem);
    void change_block(std::int64_t now_ns);
    void render_to_nowhere(std::int64_t now_ns);

    std::unique_ptr<SoundDevice> device_;
    Mixer& mixer_;
    std::function<std::int64_t()> clock_ns_;
    FrameClock frame_clock_;
    // The last frame with a sound, or when the wish to rest changed.
    std::atomic<FrameTime> quiet_since_{0};
    int block_ = block_frames;  // wanted
    int opened_block_ = block_frames;
    bool is_open_ = false;
    std::string problem_ = "Sound has not begun.";
    bool was_tried_ = false;
    std::int64_t tried_ns_ = 0;
    FrameTime seen_frame_ = 0;     // last frame the device asked for
    std::int64_t moved_ns_ = 0;    // when that last changed
    FrameTime nowhere_frame_ = 0;  // where rendering to nowhere began
    std::int64_t nowhere_ns_ = 0;
};

}  // namespace touchline
