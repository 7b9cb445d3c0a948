// A kiosk's sound on a virtual clock that is heard: the product's speaker, voice and mixer, without
// cues and without a device. Threads: one.
#pragma once

#include "app/sound/speak/speaker.h"
#include "app/sound/visitor_sound.h"
#include "audio-cues/output/outputs.h"
#include "tests/machines/sim/kiosk/house.h"

#include <memory>
#include <string>
#include <vector>

namespace touchline {

/// What came out of the headphones, and what was said when; outlives the sound.
struct Played {
    std::vector<float> left;           // at frame_rate_Hz, from the start of the kiosk
    double gain = 0.0;                 // of the output now, for one ear
    std::vector<std::size_t> said_at;  // the frame of each utterance
    std::vector<std::size_t> hushed_at;
};

class PlayedSound final : public VisitorSound {
  public:
    PlayedSound(std::shared_ptr<Heard> heard, std::shared_ptr<Played> played);

    void say(const Utterance& utterance) override;
    void hush() override;

    void toggle_pause() override { speaker_.toggle_pause(); }

    [[nodiscard]] bool is_speaking() const override {
        return speaker_.queue().current().has_value();
    }

    void give(ScreenEvent event) override { told_.give(event); }

    void play_side(bool is_left) override { told_.play_side(is_left); }

    void choose(const SoundWanted& wanted) override;

    void set_levels(const SoundSettings& levels, double lower_dB) override {
        told_.set_levels(levels, lower_dB);
    }

    /// Renders what has passed of the virtual time. The voice is waited for, as if it took none.
    void step(const HandMoment& moment) override;

    [[nodiscard]] HeardOutput output() const override;

    [[nodiscard]] std::optional<bool> are_headphones_in() const override {
        return told_.are_headphones_in();
    }

    void tell_headphones(bool are_in) override { told_.tell_headphones(are_in); }

    [[nodiscard]] std::string problem() const override { return {}; }

    [[nodiscard]] std::optional<ContactEvent> last_event() const override { return std::nullopt; }

    void forget() override;

  private:
    void wait_for_voice();

    std::shared_ptr<Heard> heard_;
    std::shared_ptr<Played> played_;
    HeardSound told_;
    SoundSettings settings_;
    Mixer mixer_;
    Speaker speaker_;
};

}  // namespace touchline
