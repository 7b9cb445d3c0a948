#include "audio-cues/synth/voices.h"

#include "tests/audio-cues/spectrum.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

Earcon one_note(double frequency_Hz, double length, Timbre timbre = Timbre::pure) {
    Earcon earcon;
    earcon.note_count = 1;
    earcon.notes[0] = {.begin_Hz = frequency_Hz,
                       .end_Hz = frequency_Hz,
                       .length_s = length,
                       .level = 0.8,
                       .timbre = timbre};
    return earcon;
}

template <class Source>
std::vector<float> heard(Source& source, std::size_t frames) {
    std::vector<StereoFrame> out(frames);
    for (std::size_t i = 0; i < frames; i += 128) {
        source.add(std::span(out).subspan(i, std::min<std::size_t>(128, frames - i)), 1.0);
    }
    return left_of_stereo(out);
}

TEST(Voice, HasTheNotesPitchAndLengthAndThenIsOver) {
    for (const double frequency_Hz : {220.0, 440.0, 1234.5, 4000.0}) {
        Voice voice(one_note(frequency_Hz, 0.25), 1.0, 0.0);
        const auto sound = heard(voice, 12288);
        EXPECT_NEAR(strongest_Hz(std::span(sound).subspan(1000, 8192)), frequency_Hz, 0.5);
        EXPECT_NEAR(peak(sound), 0.8F / std::sqrt(2.0F), 0.01F);
        for (std::size_t i = 12001; i < sound.size(); ++i) ASSERT_EQ(sound[i], 0.0F);
        EXPECT_TRUE(voice.is_over());
    }
}

TEST(Voice, EveryTimbreStartsAndStopsWithoutAClick) {
    for (const Timbre timbre : {Timbre::pure, Timbre::hollow, Timbre::bright}) {
        Voice voice(one_note(660.0, 0.06, timbre), 1.0, 0.0);
        std::vector<float> sound(1024, 0.0F);  // silence on both sides
        const auto note = heard(voice, 3072);
        sound.insert(sound.end(), note.begin(), note.end());
        sound.insert(sound.end(), 1024, 0.0F);
        EXPECT_LT(loudest_above_dB(sound, 8000.0), -60.0);
    }
    // This shows that the check works: the same note cut off is a click.
    Voice voice(one_note(660.0, 0.06), 1.0, 0.0);
    auto cut = heard(voice, 3072);
    std::fill(cut.begin() + 1510, cut.end(), 0.0F);
    EXPECT_GT(loudest_above_dB(cut, 8000.0), -55.0);
}

TEST(Voice, ADecayFallsByItsTime) {
    Earcon earcon = one_note(1000.0, 0.2);
    earcon.notes[0].decay_s = 0.05;
    Voice voice(earcon, 1.0, 0.0);
    const auto sound = heard(voice, 9600);
    const double early = rms(std::span(sound).subspan(960, 480));
    const double late = rms(std::span(sound).subspan(960 + 2400, 480));
    EXPECT_NEAR(late / early, std::exp(-1.0), 0.01);
}

TEST(Voice, WhatIsNoNumberIsSilent) {
    Earcon earcon = one_note(std::nan(""), 0.1);
    Voice voice(earcon, 1.0, 0.0);
    EXPECT_EQ(peak(heard(voice, 4800)), 0.0F);
    Voice no_gain(one_note(440.0, 0.1), std::nan(""), 0.0);
    EXPECT_EQ(peak(heard(no_gain, 4800)), 0.0F);
}

TEST(ContinuousVoice, GoesToItsPitchAndLevelWithoutAClick) {
    ContinuousVoice voice;
    voice.set({.frequency_Hz = 300.0, .level = 0.5});
    auto sound = heard(voice, 16384);
    EXPECT_NEAR(strongest_Hz(std::span(sound).subspan(4096, 8192)), 300.0, 0.5);
    voice.set({.frequency_Hz = 600.0, .level = 0.5});
    const auto after = heard(voice, 16384);
    EXPECT_NEAR(strongest_Hz(std::span(after).subspan(8192)), 600.0, 0.5);
    voice.set({.frequency_Hz = 600.0, .level = 0.0});
    const auto end = heard(voice, 2048);
    sound.insert(sound.end(), after.begin(), after.end());
    sound.insert(sound.end(), end.begin(), end.end());
    EXPECT_LT(loudest_above_dB(sound, 8000.0), -60.0);
    EXPECT_TRUE(voice.is_silent());
    EXPECT_EQ(end.back(), 0.0F);
}

TEST(ContinuousVoice, PulsesAsOftenAsItIsTold) {
    for (const double pulse_Hz : {1.5, 4.0, 12.0}) {
        ContinuousVoice voice;
        voice.set({.frequency_Hz = 500.0, .level = 0.5, .pulse_Hz = pulse_Hz});
        const auto sound = heard(voice, 4 * 48000);
        int pulses = 0;
        bool was_silent = true;
        for (std::size_t i = 0; i + 480 <= sound.size(); i += 480) {
            const bool is_silent = rms(std::span(sound).subspan(i, 480)) < 0.05;
            pulses += was_silent && !is_silent ? 1 : 0;
            was_silent = is_silent;
        }
        EXPECT_NEAR(pulses, 4.0 * pulse_Hz, 1.0);
        EXPECT_LT(loudest_above_dB(sound, 8000.0), -60.0);
    }
}

TEST(ContinuousVoice, WhatIsNoNumberIsSilentAndDoesNotLast) {
    ContinuousVoice voice;
    voice.set({.frequency_Hz = std::nan(""), .level = std::nan(""), .pulse_Hz = std::nan("")});
    EXPECT_EQ(peak(heard(voice, 4800)), 0.0F);
    voice.set({.frequency_Hz = 500.0, .level = 0.5});
    EXPECT_GT(peak(heard(voice, 4800)), 0.3F);
}

}  // namespace
}  // namespace touchline
