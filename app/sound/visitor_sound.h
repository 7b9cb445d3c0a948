// The kiosk's interface to sound: the real one (sound.h), or one that a test listens to.
// Threads: one.
#pragma once

#include "app/visit/visit_orders.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/output/outputs.h"
#include "audio-cues/speech/speech_queue.h"
#include "config/settings/sound.h"
#include "config/types/contact_event.h"
#include "config/types/hand_state.h"
#include "config/types/pinned.h"
#include "haptics/collision/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace touchline {

/// What the hand touches, several times a second.
struct HandMoment {
    HandState hand;
    const Scene* scene = nullptr;    // the scene that is felt; null: none yet
    std::optional<Position> target;  // cues tell the way to it
    bool is_nobody_here = false;     // the device may ask less often
};

/// The current output, and its steps of volume.
struct HeardOutput {
    OutputKind kind = OutputKind::headset;
    std::size_t volume_steps = 1;
    std::size_t first_volume = 0;
};

class VisitorSound : public Interface {
  public:
    virtual void say(const Utterance& utterance) = 0;

    /// Stops speech, except safety messages.
    virtual void hush() = 0;

    /// Pauses speech; the next call goes on.
    virtual void toggle_pause() = 0;

    /// True while words are being said, or wait to be.
    [[nodiscard]] virtual bool is_speaking() const = 0;

    virtual void give(ScreenEvent event) = 0;

    /// Plays a short tone on one ear, for the self-test.
    virtual void play_side(bool is_left) = 0;

    virtual void choose(const SoundWanted& wanted) = 0;

    /// Sets the site's levels, `lower_dB` softer in quiet hours.
    virtual void set_levels(const SoundSettings& levels, double lower_dB) = 0;

    virtual void step(const HandMoment& moment) = 0;

    [[nodiscard]] virtual HeardOutput output() const = 0;

    /// Nothing if it cannot be detected.
    [[nodiscard]] virtual std::optional<bool> are_headphones_in() const = 0;

    /// A keypad reported its socket.
    virtual void tell_headphones(bool are_in) = 0;

    /// Why nothing is heard; empty while sound works.
    [[nodiscard]] virtual std::string problem() const = 0;

    /// The last contact event of the hand.
    [[nodiscard]] virtual std::optional<ContactEvent> last_event() const = 0;

    /// The visitor is gone: forgets everything that was said.
    virtual void forget() = 0;
};

}  // namespace touchline
