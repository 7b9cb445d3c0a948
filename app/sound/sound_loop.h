// The thread of sound. It turns contact events into cues at their time, within a millisecond, opens
// and watches the device, and polls the headphones. It never waits for the screen, nor the screen
// for it. Threads: constructed, read and ended by one thread; it runs one of its own.
#pragma once

#include "audio-cues/cues/cue_table.h"
#include "audio-cues/output/outputs.h"
#include "audio-cues/output/sound_output.h"
#include "audio-cues/synth/mixer.h"
#include "config/types/contact_event.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace touchline {

/// Maps the servo's time to this clock. A report is never early, and now and then it comes at once,
/// so the smallest delay so far is the offset between the clocks. The offset may grow a little,
/// because the clocks may run at different speeds.
class ServoClock {
  public:
    /// A report of the servo's time `servo_s` arrived at `now_ns`.
    void told(double servo_s, std::int64_t now_ns) {
        if (!std::isfinite(servo_s) || (last_s_ && servo_s == *last_s_)) return;
        const double offset_s = 1e-9 * static_cast<double>(now_ns) - servo_s;
        const bool is_new = !last_s_ || servo_s < *last_s_;  // another servo
        const double grown_s = is_new ? offset_s : offset_s_ + drift * (servo_s - *last_s_);
        offset_s_ = std::min(offset_s, grown_s);
        last_s_ = servo_s;
    }

    /// Nothing before the first report.
    [[nodiscard]] std::optional<std::int64_t> ns_of(double servo_s) const {
        if (!last_s_ || !std::isfinite(servo_s)) return std::nullopt;
        return std::llround(1e9 * (servo_s + offset_s_));
    }

    static constexpr double drift = 1e-4;  // seconds per second

  private:
    std::optional<double> last_s_;
    double offset_s_ = 0.0;
};

/// How much is heard, and where.
struct CueSetting {
    CueAmount amount = CueAmount::cues;
    CueArea area;
    ServoClock clock;
    bool is_nobody_here = false;
};

/// Plays what the hand meets as sounds at the right time.
class HandCues {
  public:
    /// Both arguments must outlive it.
    HandCues(Mixer& mixer, const FrameClock& clock) : mixer_(mixer), clock_(clock) {}

    /// Sends the sound of this event for the frame of its time: less than 4 ms after the event if
    /// it is reported within a millisecond, else at once.
    void play(const ContactEvent& event, const CueSetting& setting);

  private:
    Mixer& mixer_;
    const FrameClock& clock_;
    CueState state_;
};

/// Gives contact events; called only from the loop's thread.
using EventSource = std::function<std::optional<ContactEvent>()>;

/// The sound hardware; null for any kind that is missing.
struct SoundWorld {
    std::unique_ptr<SoundDevice> device;
    std::unique_ptr<HeadphonePresence> input_switch;
    std::unique_ptr<HeadphonePresence> jack_control;
};

/// What the loop has found.
struct SoundNews {
    std::optional<ContactEvent> last_event;
    bool is_working = false;
    std::string problem;          // why nothing is heard; empty: it works
    HeadphoneReports headphones;  // without the keypad's: that is a key
};

/// How soon the loop looks for events again. A hand that has told none for half a minute is away:
/// the first event after that may be heard 20 ms late, those after it are not.
class PollPace {
  public:
    /// The wait until the next poll, us; `now_ns` never goes back.
    [[nodiscard]] int wait_us(bool had_event, std::int64_t now_ns) {
        if (had_event || !last_ns_) last_ns_ = now_ns;
        return is_resting(now_ns) ? 20'000 : 1000;
    }

    [[nodiscard]] bool is_resting(std::int64_t now_ns) const {
        return last_ns_ && now_ns - *last_ns_ > 30'000'000'000;
    }

  private:
    std::optional<std::int64_t> last_ns_;
};

class SoundLoop {
  public:
    /// Starts at once. The mixer must outlive it. `world.device` is not null.
    SoundLoop(Mixer& mixer, SoundWorld world, EventSource events);

    [[nodiscard]] SoundNews news() const;

    void set(const CueSetting& setting);

  private:
    void run(const std::stop_token& stop, SoundWorld world, const EventSource& events);
    /// Returns whether there was any.
    bool take_events(const EventSource& events, HandCues& cues);
    void look_after(SoundOutput& output, const SoundWorld& world, bool is_hand_away);
    [[nodiscard]] bool is_nobody_here() const;

    Mixer& mixer_;
    mutable std::mutex mutex_;  // for the two below; held while one is copied
    CueSetting setting_;
    SoundNews news_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace touchline
