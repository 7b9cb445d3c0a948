// The kiosk's sound and speech: what the visitor hears, in one part that the kiosk steps.
// Threads: one, the kiosk's; it runs the sound loop's (sound_loop.h), and the device has its own.
#pragma once

#include "app/session/keys.h"
#include "app/sound/sound_choice.h"
#include "app/sound/sound_loop.h"
#include "app/sound/spoken_news.h"
#include "app/speak/speaker.h"
#include "config/types/hand_state.h"
#include "haptics/collision/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// What sound is made from; all of it may be missing but the languages, which hold English.
struct SoundParts {
    SoundWorld world;
    SoundSettings settings;
    Languages languages{Language()};
    RecordedPrompts prompts;
    std::string speak_program;          // touchline-speak
    std::vector<std::string> problems;  // a line each, for the operator
};

/// This machine's: SDL2, evdev, ALSA, the installed files.
[[nodiscard]] SoundParts sound_parts();

/// What the kiosk is doing, 60 times a second.
struct SoundMoment {
    SpokenState spoken;
    HandState hand;
    const Scene* scene = nullptr;  // felt; null: none yet
};

class Sound {
  public:
    /// Begins at once. `events` is called from another thread, until destruction.
    Sound(SoundParts parts, EventSource events);

    /// A key went down: its click, and speech stops. `action`: what it means; nothing: nothing
    /// here.
    void key_down(std::optional<Action> action);

    /// A key for sound or speech (Commands::sound).
    void carry_out(Action action);

    void step(const SoundMoment& moment);

    [[nodiscard]] const std::optional<ContactEvent>& last_event() const { return news_.last_event; }

    /// For the panel: "short ones, volume 4 of 7", or why nothing is heard.
    [[nodiscard]] std::string words() const;

    /// For the screen, to a person: empty while somebody could hear.
    [[nodiscard]] std::string problem() const;

    [[nodiscard]] const SoundChoice& choice() const { return choice_; }

    /// That is spoken now.
    [[nodiscard]] const Language& language() const;

    [[nodiscard]] const Speaker& speaker() const { return speaker_; }

    [[nodiscard]] Mixer& mixer() { return mixer_; }

  private:
    void apply(const SoundStep& step);
    void say(const Utterance& utterance);
    void give(ScreenEvent event);
    void follow_headphones();
    void follow_news(const SpokenState& now);
    void follow_hand(const SoundMoment& moment);

    SoundSettings settings_;
    Languages languages_;
    SoundChoice choice_;
    Mixer mixer_;
    SoundLoop loop_;
    Speaker speaker_;
    SoundNews news_;
    std::optional<bool> keypad_;  // what it said of its socket
    std::optional<SpokenState> before_;
    CueState screen_cues_;
    CueSetting hand_cues_;
    bool is_tone_on_ = false;
};

}  // namespace touchline
