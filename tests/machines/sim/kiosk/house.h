// What every kiosk in a test takes from its site: languages, pictures, the operator's files, and a
// sound that records what would be said and given.
// Threads: any, as what is read once is shared and constant; one for the sound.
#pragma once

#include "app/kiosk/operator_session.h"
#include "app/kiosk/pictures.h"
#include "app/sound/visitor_sound.h"
#include "audio-cues/words/language.h"

#include <filesystem>
#include <string>
#include <vector>

namespace touchline {

/// Returns the languages that a kiosk offers at first, in that order.
[[nodiscard]] std::vector<Language> all_languages();

/// Returns the real gallery, opened by the real workers.
[[nodiscard]] Gallery whole_gallery(const std::vector<Language>& languages);

/// Returns the lines of the real gallery on blank pages, read once: no process, no pixels.
[[nodiscard]] const Gallery& gallery_without_workers();

/// Returns the operator's files in this folder, and makes the folder.
[[nodiscard]] OperatorFiles site_files_in(const std::filesystem::path& folder);

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

    [[nodiscard]] bool is_speaking() const override { return false; }

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
