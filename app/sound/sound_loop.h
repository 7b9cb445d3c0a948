// The thread of sound. It turns contact events into cues within a millisecond, opens and watches
// the device, and polls the headphones. It never waits for the screen, nor the screen for it.
// Threads: constructed, read and ended by one thread; it runs one of its own.
#pragma once

#include "app/sound/hand_cues.h"
#include "audio-cues/output/headphones.h"
#include "audio-cues/output/sound_output.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace touchline {

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

class SoundLoop {
  public:
    /// Starts at once. The mixer must outlive it. `world.device` is not null.
    SoundLoop(Mixer& mixer, SoundWorld world, EventSource events);

    [[nodiscard]] SoundNews news() const;

    void set(const CueSetting& setting);

    static constexpr int poll_us = 1000;

  private:
    void run(const std::stop_token& stop, SoundWorld world, const EventSource& events);
    void take_events(const EventSource& events, HandCues& cues);
    void look_after(SoundOutput& output, const SoundWorld& world);

    Mixer& mixer_;
    mutable std::mutex mutex_;  // for the two below; held while one is copied
    CueSetting setting_;
    SoundNews news_;
    std::jthread thread_;  // last: it uses all of the above
};

}  // namespace touchline
