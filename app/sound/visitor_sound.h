// What the kiosk can do to be heard: the real sound (sound.h), or one that a test listens to.
// Threads: one.
#pragma once

#include "app/session/visit_orders.h"
#include "audio-cues/cues/screen_event.h"
#include "audio-cues/output/profile.h"
#include "audio-cues/speech/speech_queue.h"
#include "config/settings/sound.h"
#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace touchline {

/// What the hand is on, several times a second.
struct HandMoment {
    HandState hand;
    const Scene* scene = nullptr;    // felt; null: none yet
    std::optional<Position> target;  // the way to it is heard
};

/// The output that is heard now, and its steps of volume.
struct HeardOutput {
    OutputKind kind = OutputKind::headset;
    std::size_t volume_steps = 1;
    std::size_t first_volume = 0;
};

class VisitorSound {
  public:
    VisitorSound() = default;
    virtual ~VisitorSound() = default;
    VisitorSound(const VisitorSound&) = delete;
    VisitorSound(VisitorSound&&) = delete;
    VisitorSound& operator=(const VisitorSound&) = delete;
    VisitorSound& operator=(VisitorSound&&) = delete;

    virtual void say(const Utterance& utterance) = 0;

    /// Speech stops, but for safety messages.
    virtual void hush() = 0;

    /// The next one goes on.
    virtual void toggle_pause() = 0;

    virtual void give(ScreenEvent event) = 0;

    /// A short tone on one ear, for the self-test.
    virtual void play_side(bool is_left) = 0;

    virtual void choose(const SoundWanted& wanted) = 0;

    /// The levels of the site, `lower_dB` softer in quiet hours.
    virtual void set_levels(const SoundSettings& levels, double lower_dB) = 0;

    virtual void step(const HandMoment& moment) = 0;

    [[nodiscard]] virtual HeardOutput output() const = 0;

    /// Nothing where nobody can tell.
    [[nodiscard]] virtual std::optional<bool> are_headphones_in() const = 0;

    /// A keypad told of its socket.
    virtual void tell_headphones(bool are_in) = 0;

    /// Why nothing is heard; empty while somebody could hear.
    [[nodiscard]] virtual std::string problem() const = 0;

    /// The last thing that the hand did.
    [[nodiscard]] virtual std::optional<ContactEvent> last_event() const = 0;

    /// The visitor is gone: nothing of what was said stays.
    virtual void forget() = 0;
};

}  // namespace touchline
