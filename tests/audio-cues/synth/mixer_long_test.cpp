#include "audio-cues/synth/mixer.h"
#include "tests/audio-cues/spectrum.h"

#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr FrameTime hour = FrameTime{3600} * frame_rate_Hz;

/// A second of a busy hand with speech, from frame `start` of the mixer.
std::vector<StereoFrame> busy_second(Mixer& mixer, FrameTime start) {
    Earcon earcon;
    earcon.note_count = 1;
    mixer.speech().cut();
    mixer.send({start, SetOutput{0.8, 0.5, false}});
    for (int i = 0; i < 10; ++i) {
        mixer.send({start + 4000 * i, PlayEarcon{earcon, 0.5, 0.1 * i - 0.5, i % 3 == 0}});
    }
    mixer.send(
        {start + 100, SetContinuous{{.frequency_Hz = 333.0, .level = 0.2, .pulse_Hz = 6.0}}});
    mixer.send({start + 30000, SetContinuous{{.frequency_Hz = 333.0, .level = 0.0}}});
    const std::vector<float> speech(24000, 0.3F);
    (void)mixer.speech().write(speech);
    return rendered(mixer, static_cast<std::size_t>(frame_rate_Hz));
}

TEST(MixerLong, EightHoursOnEverySampleIsWhatItWasAtTheStart) {
    Mixer fresh;
    Mixer old(8 * hour);
    EXPECT_EQ(busy_second(fresh, 0), busy_second(old, 8 * hour));
}

/// Runs 8 h with TOUCHLINE_EXHAUSTIVE, otherwise a minute: the last second sounds like the second
/// one, when everything had sounded once.
TEST(MixerLong, ALongSessionNeitherDriftsNorGrows) {
    const FrameTime seconds = std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? 8 * 3600 : 60;
    const auto mixer = std::make_unique<Mixer>();
    std::vector<StereoFrame> second;
    for (FrameTime i = 0; i < seconds; ++i) {
        auto now = busy_second(*mixer, i * frame_rate_Hz);
        if (i == 1) second = now;
        if (i + 1 == seconds) {
            const double before = rms(left_of_stereo(second));
            EXPECT_NEAR(rms(left_of_stereo(now)) / before, 1.0, 1e-3);
        }
    }
    EXPECT_EQ(mixer->now(), seconds * frame_rate_Hz);
    EXPECT_EQ(mixer->lost(), 0U);
}

}  // namespace
}  // namespace touchline
