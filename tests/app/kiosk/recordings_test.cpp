// Tests whole visits to pictures of a pack that somebody recorded: what comes out of the
// headphones.
#include "app/documents/gallery/gallery.h"
#include "app/documents/packs/pack_library.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/app/kiosk/blind_visitor.h"
#include "tests/app/kiosk/kiosk_world.h"
#include "tests/app/kiosk/played_sound.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

#include <gtest/gtest.h>
#include <sndfile.h>

namespace touchline {
namespace {

constexpr double title_Hz = 500.0;
constexpr double description_Hz = 800.0;
constexpr double sail_Hz = 1100.0;
constexpr float loudness = 0.5F;

/// A boat with a hull and a sail; the two are 10 mm apart.
constexpr const char* boat_svg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"116mm\" height=\"84mm\" "
    "viewBox=\"0 0 116 84\" data-difficulty=\"1\"><title>A cutter</title>"
    "<title xml:lang=\"de\">Ein Kutter</title><desc>It lies at the quay.</desc>"
    "<desc xml:lang=\"de\">Er liegt am Kai.</desc>"
    "<path id=\"hull\" d=\"M18 58 L98 58 L88 74 L28 74 Z\"><title>Hull</title>"
    "<title xml:lang=\"de\">Rumpf</title></path>"
    "<path id=\"sail\" d=\"M38 48 L78 48 L58 10 Z\"><title>Sail</title>"
    "<title xml:lang=\"de\">Segel</title></path></svg>";

PackFile tone(const std::string& name, double tone_Hz, double long_s) {
    return {name, made::recording(SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, long_s, 1, loudness,
                                  static_cast<float>(tone_Hz))};
}

Pack recorded_pack() {
    Pack pack;
    pack.info = {"quay",
                 {{"", "At the quay"}},
                 "A museum",
                 "CC0-1.0",
                 {1, 0, 0},
                 {"en", "de"},
                 {{"cutter.svg", 1}},
                 {{"d.wav", "cutter.svg", "en", SoundText::description, ""},
                  {"s.wav", "cutter.svg", "en", SoundText::part, "sail"},
                  {"t.wav", "cutter.svg", "en", SoundText::title, ""}}};
    pack.files = {{"cutter.svg", made::bytes_of(boat_svg)},
                  tone("d.wav", description_Hz, 3.0),
                  {"pack.toml", made::bytes_of(toml_of(pack.info))},
                  tone("s.wav", sail_Hz, 4.0),
                  tone("t.wav", title_Hz, 1.0)};
    return pack;
}

/// A kiosk with that pack, and what is heard of it.
class RecordedVisit : public testing::Test {
  protected:
    RecordedVisit() {
        const auto place = import_pack(recorded_pack(), library_.path());
        EXPECT_TRUE(place.has_value()) << sentence_of(place.error(), Language());
        world_ = std::make_unique<KioskWorld>(
            false, read_gallery(gallery_folder(), library_.path(), all_languages()).value(),
            ThingFinder(), [this](const std::shared_ptr<Heard>& heard) {
                return std::make_unique<PlayedSound>(heard, played_);
            });
        visitor_ = std::make_unique<BlindVisitor>(*world_);
    }

    void open_cutter(const std::string& language = "English",
                     const std::string& cutter = "A cutter") {
        visitor_->press(KeyRole::select);
        ASSERT_TRUE(visitor_->choose(language)) << visitor_->heard();
        const Language& spoken = world_->kiosk().language();
        ASSERT_TRUE(visitor_->choose(spoken.text("visit", "Gallery"))) << visitor_->heard();
        ASSERT_TRUE(visitor_->choose_picture(cutter)) << visitor_->heard();
        ASSERT_TRUE(visitor_->wait_for(cutter + ". ")) << visitor_->heard();
    }

    [[nodiscard]] std::size_t now() const { return played_->left.size(); }

    /// The amplitude of a tone in what was heard in the frames from `first` on.
    [[nodiscard]] double amplitude(double tone_Hz, std::size_t first, double long_s) const {
        const auto count = static_cast<std::size_t>(long_s * frame_rate_Hz);
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < count && first + i < played_->left.size(); ++i)
            sum += static_cast<double>(played_->left[first + i]) *
                   std::polar(1.0, -2.0 * std::numbers::pi * tone_Hz * static_cast<double>(i) /
                                       frame_rate_Hz);
        return 2.0 * std::abs(sum) / static_cast<double>(count);
    }

    /// That of a recording at the volume now: as loud as the voice.
    [[nodiscard]] double expected() const {
        return played_->gain * std::pow(10.0, -speech_below_full_dB / 20.0);
    }

    /// Leads the hand to a place of the SVG.
    void feel(double x_mm, double y_mm) {
        lead_hand(*world_, {(x_mm - 58.0) / 1000.0, (42.0 - y_mm) / 1000.0});
    }

    ScratchFolder library_;
    std::shared_ptr<Played> played_ = std::make_shared<Played>();
    std::unique_ptr<KioskWorld> world_;
    std::unique_ptr<BlindVisitor> visitor_;
};

TEST_F(RecordedVisit, TitleThenDescriptionThenTheVoiceAtTheVisitorsVolume) {
    open_cutter();
    const std::size_t said = played_->said_at.back();
    world_->run(8.0);
    // The title's samples, one by one, from the first frame on: only the limiter delays them.
    const std::size_t first = said + Limiter::look_ahead_frames;
    for (std::size_t i = 2000; i < 47000; ++i) {
        const double wanted = expected() * std::sin(2.0 * std::numbers::pi * title_Hz *
                                                    static_cast<double>(i) / frame_rate_Hz);
        ASSERT_NEAR(static_cast<double>(played_->left[first + i]), wanted, 0.01 * expected()) << i;
    }
    EXPECT_LT(amplitude(title_Hz, first + 48200, 0.2), 0.01 * expected()) << "a short silence";
    const std::size_t description = first + 48000 + 12000;
    EXPECT_NEAR(amplitude(description_Hz, description, 3.0), expected(), 0.02 * expected());
    EXPECT_LT(amplitude(title_Hz, description, 3.0), 0.02 * expected());
    const std::size_t voice = description + 3 * 48000 + 12000;
    EXPECT_GT(rms(std::span(played_->left).subspan(voice, 24000)), 0.1 * expected())
        << "how many outlines there are nobody recorded";
    EXPECT_TRUE(visitor_->heard().find("A cutter. It lies at the quay. 2 outlines.") !=
                std::string::npos)
        << visitor_->heard();
    EXPECT_TRUE(
        world_->kiosk().caption().starts_with("A cutter. It lies at the quay. 2 outlines."));
}

TEST_F(RecordedVisit, AKeyStopsItAndRepeatPlaysItLouder) {
    open_cutter();
    world_->run(2.0);
    EXPECT_NEAR(amplitude(description_Hz, now() - 12000, 0.25), expected(), 0.05 * expected());
    const double before = expected();
    visitor_->press(KeyRole::louder);
    const std::size_t key = played_->hushed_at.back();
    EXPECT_LT(amplitude(description_Hz, key + 2400, 0.25), 0.3 * before)
        << "50 ms; the voice, which says the volume, has a little of that tone";
    visitor_->press(KeyRole::repeat);
    EXPECT_EQ(visitor_->heard().find("Volume"), 0U) << "the last words, not the recording";
    ASSERT_TRUE(visitor_->choose("Tell me again")) << visitor_->heard();
    const std::size_t said = played_->said_at.back();
    world_->run(6.0);
    const double louder = amplitude(description_Hz, said + 62000, 2.5);
    EXPECT_NEAR(louder, expected(), 0.02 * expected());
    EXPECT_GT(louder, 1.5 * before);
}

TEST_F(RecordedVisit, WithoutARecordingInTheLanguageTheVoiceSaysIt) {
    open_cutter("Deutsch", "Ein Kutter");
    const std::size_t said = played_->said_at.back();
    world_->run(8.0);
    EXPECT_GT(rms(std::span(played_->left).subspan(said, 96000)), 0.1 * expected());
    for (const double tone_Hz : {title_Hz, description_Hz})
        EXPECT_LT(amplitude(tone_Hz, said, 6.0), 0.1 * expected()) << tone_Hz;
}

TEST_F(RecordedVisit, APartIsHeardWhileTheHandIsOnIt) {
    open_cutter();
    visitor_->press(KeyRole::down);
    world_->run(9.0);  // to the end of what the key made it say
    feel(58.0, 10.0);
    ASSERT_TRUE(visitor_->wait_for("Sail")) << visitor_->heard();
    world_->run(1.5);
    EXPECT_NEAR(amplitude(sail_Hz, now() - 24000, 0.5), expected(), 0.02 * expected());
    feel(18.0, 58.0);
    ASSERT_TRUE(visitor_->wait_for("Hull")) << visitor_->heard();
    const std::size_t left = played_->said_at.back();
    world_->run(1.0);
    EXPECT_LT(amplitude(sail_Hz, left + 2400, 0.8), 0.1 * expected())
        << "the hand is elsewhere, and the rest of the sail is not heard";
    EXPECT_GT(rms(std::span(played_->left).subspan(left, 24000)), 0.1 * expected());
}

TEST_F(RecordedVisit, NothingOfItStaysInMemoryAfterTheVisit) {
    open_cutter();
    world_->run(1.0);
    const auto recording = [this] {
        return std::weak_ptr(world_->kiosk().visit().visitor.felt->facts.parts.at(1).recording);
    }();
    EXPECT_FALSE(recording.expired());
    world_->run(200.0);
    EXPECT_FALSE(is_visit_on(world_->kiosk().visit()));
    EXPECT_TRUE(recording.expired());
}

TEST_F(RecordedVisit, ARecordingThatIsGoneIsSaid) {
    std::filesystem::remove(library_.path() / "quay" / "d.wav");
    open_cutter();
    const std::size_t said = played_->said_at.back();
    world_->run(6.0);
    EXPECT_NEAR(amplitude(title_Hz, said + 4800, 0.8), expected(), 0.02 * expected());
    EXPECT_GT(rms(std::span(played_->left).subspan(said + 60000, 48000)), 0.1 * expected());
    EXPECT_LT(amplitude(description_Hz, said + 60000, 3.0), 0.1 * expected());
}

}  // namespace
}  // namespace touchline
