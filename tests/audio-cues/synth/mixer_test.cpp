#include "audio-cues/synth/mixer.h"

#include "tests/audio-cues/spectrum.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Earcon tick() {
    Earcon earcon;
    earcon.note_count = 1;
    earcon.notes[0] = {.begin_Hz = 1000.0, .end_Hz = 1000.0, .length_s = 0.05, .level = 0.5};
    return earcon;
}

std::vector<float> noise(std::size_t count, float level) {
    std::vector<float> samples(count);
    unsigned state = 1;
    for (float& sample : samples) {
        state = state * 1664525U + 1013904223U;
        sample = level * (float(state >> 8U) / 8388608.0F - 1.0F);
    }
    return samples;
}

class MixerTest : public testing::Test {
  protected:
    std::vector<StereoFrame> render(std::size_t frames) { return rendered(*mixer_, frames); }

    void steady(double level) {
        mixer_->send({0, SetContinuous{{.frequency_Hz = 480.0, .level = level}}});
    }

    std::unique_ptr<Mixer> mixer_ = std::make_unique<Mixer>();
};

TEST_F(MixerTest, AClickSoundsWithinOneBlockOfItsTimeStamp) {
    for (const FrameTime frame : {0, 1, 127, 128, 1000, 5003}) {
        for (const double pan : {-1.0, 0.0, 1.0}) {
            Mixer mixer;
            mixer.send({frame, PlayEarcon{tick(), 1.0, pan}});
            const auto out = rendered(mixer, 8192);
            for (const auto& ear : {left_of_stereo(out), right_of_stereo(out)}) {
                const auto first = static_cast<FrameTime>(first_sound(ear));
                EXPECT_GE(first, frame + Limiter::look_ahead_frames);
                EXPECT_LE(first, frame + block_frames);
            }
        }
    }
}

TEST_F(MixerTest, FromATickOfTheServoToTheEarTakesTenMillisecondsAtMost) {
    // A device asks for a period while two are under way; an event comes one tick before it is
    // seen, and the next block carries it.
    constexpr double tick_s = 0.001;
    constexpr double device_s = 2.0 * block_frames / frame_rate_Hz;
    (void)render(block_frames);
    mixer_->send({0, PlayEarcon{tick()}});  // already late: plays at once
    const auto sound = left_of_stereo(render(1024));
    const double in_block_s = static_cast<double>(first_sound(sound)) / frame_rate_Hz;
    EXPECT_LE(tick_s + in_block_s + device_s, 0.010);
}

TEST_F(MixerTest, CommandsOfOneThreadTakeEffectInTheOrderOfTheirFrames) {
    mixer_->send({3000, SetContinuous{{.frequency_Hz = 480.0, .level = 0.0}}});
    mixer_->send({1000, SetContinuous{{.frequency_Hz = 480.0, .level = 0.5}}});
    const auto sound = left_of_stereo(render(6000));
    EXPECT_NEAR(double(first_sound(sound)), 1000.0 + 64.0, 3.0);
    EXPECT_GT(rms(std::span(sound).subspan(2000, 1000)), 0.2);
    EXPECT_EQ(peak(std::span(sound).subspan(3400)), 0.0F);
}

TEST_F(MixerTest, BlocksOfAnySizeGiveTheSameSamples) {
    const auto play = [](Mixer& mixer, std::size_t size) {
        mixer.send({100, PlayEarcon{tick(), 1.0, 0.3}});
        mixer.send({900, PlayEarcon{tick(), 0.5, -0.8}});
        std::vector<StereoFrame> all;
        while (all.size() < 6000) {
            std::vector<StereoFrame> part(size);
            mixer.render(part);
            all.insert(all.end(), part.begin(), part.end());
        }
        all.resize(6000);
        return left_of_stereo(all);
    };
    Mixer other;
    const auto by_128 = play(*mixer_, 128);
    const auto by_37 = play(other, 37);
    for (std::size_t i = 0; i < by_128.size(); ++i) ASSERT_NEAR(by_128[i], by_37[i], 1e-6F);
}

TEST_F(MixerTest, SpeechPushesTheContinuousSoundDownByTwelveDecibelsAndInTime) {
    steady(0.5);
    (void)render(9600);
    const double before = rms(left_of_stereo(render(4800)));
    const std::vector<float> silence(24000, 0.0F);  // silent speech: only the ducking is heard
    (void)mixer_->speech().write(silence);
    const auto ducked = left_of_stereo(render(24000));
    const auto level_dB = [&](std::span<const float> sound, double at_s) {
        const auto start = static_cast<std::size_t>(at_s * frame_rate_Hz) + 64;
        return dB_of_gain(rms(sound.subspan(start, 500)) / before);
    };
    EXPECT_GT(level_dB(ducked, 0.0), -6.0);
    EXPECT_NEAR(level_dB(ducked, 0.035), -12.0, 0.2) << "down in 30 ms";
    EXPECT_NEAR(level_dB(ducked, 0.4), -12.0, 0.2);
    const auto after = left_of_stereo(render(48000));
    EXPECT_NEAR(level_dB(after, 0.28), -12.0, 0.3) << "held over the pause between sentences";
    EXPECT_NEAR(level_dB(after, 0.42), -6.0, 1.0) << "half way up";
    EXPECT_NEAR(level_dB(after, 0.57), 0.0, 0.1) << "back";
}

TEST_F(MixerTest, SP4_SpeechIsSilentWithinFiftyMillisecondsOfAKey) {
    (void)mixer_->speech().write(noise(48000, 0.5F));
    EXPECT_GT(rms(left_of_stereo(render(9600))), 0.1);
    mixer_->speech().cut();
    const auto sound = left_of_stereo(render(9600));
    EXPECT_GT(peak(std::span(sound).first(100)), 0.0F);
    EXPECT_EQ(peak(std::span(sound).subspan(2400)), 0.0F);  // 50 ms
    EXPECT_EQ(peak(std::span(sound).subspan(240 + 64)), 0.0F)
        << "in fact the ramp and the look-ahead";
}

TEST_F(MixerTest, APauseKeepsTheRestOfTheSpeech) {
    (void)mixer_->speech().write(noise(9600, 0.5F));
    (void)render(1280);
    mixer_->send({0, PauseSpeech{true}});
    (void)render(1280);
    EXPECT_EQ(peak(left_of_stereo(render(48000))), 0.0F);
    EXPECT_GT(mixer_->speech().waiting(), 8000U);
    mixer_->send({0, PauseSpeech{false}});
    EXPECT_GT(rms(left_of_stereo(render(4800))), 0.1);
}

TEST_F(MixerTest, VO6_MonoIsTheSameForBothEarsBitForBit) {
    mixer_->send({0, SetOutput{1.0, 1.0, true}});
    (void)render(2400);
    mixer_->send({0, PlayEarcon{tick(), 1.0, 1.0}});
    mixer_->send({0, SetContinuous{{.frequency_Hz = 480.0, .level = 0.2, .pan = -1.0}}});
    (void)mixer_->speech().write(noise(4800, 0.2F));
    const auto out = render(9600);
    EXPECT_GT(peak(left_of_stereo(out)), 0.1F);
    for (const StereoFrame& frame : out) ASSERT_EQ(frame.left, frame.right);
}

TEST_F(MixerTest, VO6_NoEarIsMoreThanTwentyDecibelsBelowTheOther) {
    for (const double pan : {-1.0, -0.5, 0.5, 1.0}) {
        Mixer mixer;
        mixer.send({0, SetContinuous{{.frequency_Hz = 480.0, .level = 0.3, .pan = pan}}});
        const auto out = rendered(mixer, 9600);
        const double left = rms(std::span<const float>(left_of_stereo(out)).subspan(4800));
        const double right = rms(std::span<const float>(right_of_stereo(out)).subspan(4800));
        const double difference_dB = dB_of_gain(right / left);
        EXPECT_LE(std::abs(difference_dB), 20.1);
        EXPECT_GT(difference_dB * pan, 0.0);
    }
}

TEST_F(MixerTest, VO3_NothingIsAboveTheCapWithEveryBusAtItsLoudest) {
    mixer_->send({0, SetOutput{4.0, 0.25, false}});
    mixer_->send({0, SetContinuous{{.frequency_Hz = 480.0, .level = 1.0, .pan = 1.0}}});
    for (int i = 0; i < 8; ++i) {
        mixer_->send({i * 600, PlayEarcon{tick(), 1.0, 1.0, i % 2 == 0}});
    }
    (void)mixer_->speech().write(noise(40000, 1.0F));
    const auto out = render(40000);
    EXPECT_LE(peak(left_of_stereo(out)), 0.25F);
    EXPECT_LE(peak(right_of_stereo(out)), 0.25F);
    EXPECT_GT(peak(right_of_stereo(out)), 0.2F);
}

TEST_F(MixerTest, ChangesOfVolumeAndOfBussesDoNotClick) {
    steady(0.5);
    (void)render(4800);
    std::vector<float> sound;
    for (const double gain : {0.1, 1.0, 0.0, 0.7}) {
        mixer_->send({0, SetOutput{gain, 1.0, false}});
        mixer_->send({0, SetBusLevel{Bus::continuous, 1.0 - gain / 2.0}});
        const auto part = left_of_stereo(render(2048));
        sound.insert(sound.end(), part.begin(), part.end());
    }
    EXPECT_LT(loudest_above_dB(sound, 8000.0), -60.0);
}

TEST_F(MixerTest, AnAlertPushesSpeechDown) {
    (void)mixer_->speech().write(noise(48000, 0.1F));
    (void)render(4800);
    const double before = rms(left_of_stereo(render(4800)));
    Earcon quiet = tick();
    quiet.notes[0].length_s = 0.3;
    quiet.notes[0].level = 0.0;
    mixer_->send({0, PlayEarcon{quiet, 1.0, 0.0, true}});
    (void)render(4800);
    EXPECT_NEAR(dB_of_gain(rms(left_of_stereo(render(4800))) / before), -12.0, 0.5);
}

TEST_F(MixerTest, TheNinthEarconAtOnceIsDroppedAndCounted) {
    for (int i = 0; i < 9; ++i) mixer_->send({0, PlayEarcon{tick()}});
    (void)render(128);
    EXPECT_EQ(mixer_->lost(), 1U);
    (void)render(4800);
    mixer_->send({0, PlayEarcon{tick()}});
    (void)render(128);
    EXPECT_EQ(mixer_->lost(), 1U) << "the voices are free again";
}

}  // namespace
}  // namespace touchline
