// Everything that is heard: speech, the cues of keys, screens and the hand; also detects
// headphones.
// Threads: one, the screen's; it starts another for the sounds of the hand's events (sound_loop.h).
// No call waits.
#pragma once

#include "app/sound/catalogues.h"
#include "app/sound/sound_loop.h"
#include "app/sound/speak/speaker.h"
#include "app/sound/visitor_sound.h"
#include "audio-cues/cues/cue_table.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

struct SoundParts {
    SoundWorld world;
    SoundSettings settings;
    Languages languages{Language()};
    RecordedPrompts prompts;
    std::string speak_program;          // touchline-speak
    std::vector<std::string> problems;  // one line each, for the operator
};

/// The kiosk's parts: a sound card, keypad, jack, and the installed catalogues and levels.
[[nodiscard]] SoundParts sound_parts();

class Sound final : public VisitorSound {
  public:
    /// Starts at once. `events` is called from another thread, until destruction.
    Sound(SoundParts parts, EventSource events);

    void say(const Utterance& utterance) override;
    void hush() override;
    void toggle_pause() override;

    [[nodiscard]] bool is_speaking() const override {
        return speaker_.queue().current().has_value();
    }

    void give(ScreenEvent event) override;
    void play_side(bool is_left) override;
    void choose(const SoundWanted& wanted) override;
    void set_levels(const SoundSettings& levels, double lower_dB) override;
    void step(const HandMoment& moment) override;
    [[nodiscard]] HeardOutput output() const override;
    [[nodiscard]] std::optional<bool> are_headphones_in() const override;

    void tell_headphones(bool are_in) override {
        keypad_ = are_in;
        follow_headphones();
    }

    [[nodiscard]] std::string problem() const override;

    [[nodiscard]] std::optional<ContactEvent> last_event() const override {
        return news_.last_event;
    }

    void forget() override { speaker_.forget(); }

    [[nodiscard]] const Speaker& speaker() const { return speaker_; }

    [[nodiscard]] Mixer& mixer() { return mixer_; }

  private:
    void send_output();
    void follow_headphones();
    void follow_hand(const HandMoment& moment);

    SoundSettings settings_;
    Languages languages_;
    SoundWanted wanted_;
    OutputKind output_;
    double lower_dB_ = 0.0;
    Mixer mixer_;
    SoundLoop loop_;
    Speaker speaker_;
    SoundNews news_;
    std::optional<bool> keypad_;  // the keypad's report of its socket
    CueState screen_cues_;
    CueSetting hand_cues_;
    bool is_tone_on_ = false;
};

}  // namespace touchline
