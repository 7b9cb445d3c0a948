// A sound that records what would be said and given. Threads: one.
#pragma once

#include "app/sound/visitor_sound.h"

#include <string>
#include <vector>

namespace touchline {

/// One utterance or cue, with its time.
struct HeardThing {
    double at_s = 0.0;
    std::string language;
    std::string text;  // empty: a cue
    ScreenEvent event = ScreenEvent::key_taken;
};

/// Everything heard; outlives the kiosk's sound.
struct Heard {
    double now_s = 0.0;
    std::vector<HeardThing> things;
    int hushes = 0;
    int forgotten = 0;
    SoundWanted wanted;
    SoundSettings levels;
    double lower_dB = 0.0;
    std::optional<bool> headphones;
    std::string problem;

    /// Returns the text since `first`, in order, one utterance a line.
    [[nodiscard]] std::string text_since(std::size_t first) const;

    [[nodiscard]] std::string last_text() const;

    [[nodiscard]] bool was_said(const std::string& part, std::size_t first = 0) const;
};

class HeardSound final : public VisitorSound {
  public:
    explicit HeardSound(std::shared_ptr<Heard> heard) : heard_(std::move(heard)) {}

    void say(const Utterance& utterance) override;

    void hush() override { ++heard_->hushes; }

    void toggle_pause() override {}

    void give(ScreenEvent event) override;

    void play_side(bool is_left) override;

    void choose(const SoundWanted& wanted) override { heard_->wanted = wanted; }

    void set_levels(const SoundSettings& levels, double lower_dB) override {
        heard_->levels = levels;
        heard_->lower_dB = lower_dB;
    }

    void step(const HandMoment&) override {}

    [[nodiscard]] HeardOutput output() const override { return {OutputKind::headset, 7, 3}; }

    [[nodiscard]] std::optional<bool> are_headphones_in() const override {
        return heard_->headphones;
    }

    void tell_headphones(bool are_in) override { heard_->headphones = are_in; }

    [[nodiscard]] std::string problem() const override { return heard_->problem; }

    [[nodiscard]] std::optional<ContactEvent> last_event() const override { return std::nullopt; }

    void forget() override;

  private:
    std::shared_ptr<Heard> heard_;
};

}  // namespace touchline
