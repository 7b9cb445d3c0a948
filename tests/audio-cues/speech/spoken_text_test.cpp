// Tests texts of which parts are recorded, and how loud a recording is beside the voice.
#include "audio-cues/speech/spoken_text.h"

#include "audio-cues/output/outputs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::vector<std::int16_t> tone(double amplitude, double long_s) {
    std::vector<std::int16_t> samples(static_cast<std::size_t>(long_s * frame_rate_Hz));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<std::int16_t>(std::lround(
            32767.0 * amplitude *
            std::sin(2.0 * std::numbers::pi * 440.0 * static_cast<double>(i) / frame_rate_Hz)));
    return samples;
}

VoiceRecordingPtr some_recording(double long_s = 0.1) {
    return std::make_shared<const VoiceRecording>(recording_of(tone(0.5, long_s)));
}

TEST(SpokenText, IsCutWhereRecordingsBeginAndEnd) {
    const VoiceRecordingPtr boat = some_recording();
    const VoiceRecordingPtr sea = some_recording();
    SpokenText text("A boat. It is at sea. 3 outlines. Parts, 1 of 4");
    text.recorded = {{0, 6, boat}, {8, 21, sea}};
    const std::vector<SpeechPiece> wanted{
        {"A boat", boat}, {"It is at sea.", sea}, {"3 outlines. Parts, 1 of 4", nullptr}};
    EXPECT_EQ(pieces_of(text), wanted) << "the stop after the boat is no word";
}

TEST(SpokenText, WithoutARecordingIsOnePieceAsItIs) {
    EXPECT_EQ(pieces_of(", a stop."), (std::vector<SpeechPiece>{{", a stop.", nullptr}}));
    EXPECT_TRUE(SpokenText("a", nullptr).recorded.empty());
}

TEST(SpokenText, ASpanThatCannotBeIsLeftToTheVoice) {
    const VoiceRecordingPtr sound = some_recording();
    const std::vector<std::vector<RecordedSpan>> impossible{
        {{0, 5, sound}},
        {{2, 2, sound}},
        {{3, 1, sound}},
        {{0, 4, nullptr}},
        {{0, 4, std::make_shared<const VoiceRecording>()}}};
    for (const auto& spans : impossible) {
        SpokenText text("abcd");
        text.recorded = spans;
        EXPECT_EQ(pieces_of(text), (std::vector<SpeechPiece>{{"abcd", nullptr}}));
    }
    SpokenText text("abcd");
    text.recorded = {{1, 3, sound}, {2, 4, sound}};
    EXPECT_EQ(pieces_of(text),
              (std::vector<SpeechPiece>{{"a", nullptr}, {"bc", sound}, {"d", nullptr}}));
}

/// Letters and digits come once each, in order, whatever the spans are.
RC_GTEST_PROP(SpokenText, NoWordIsLostOrSaidTwice, ()) {
    SpokenText text(*rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab 1.,!"))));
    const VoiceRecordingPtr sound = some_recording();
    const auto spans = *rc::gen::container<std::vector<std::pair<std::size_t, std::size_t>>>(
        rc::gen::pair(rc::gen::inRange<std::size_t>(0, 30), rc::gen::inRange<std::size_t>(0, 30)));
    for (const auto& [begin, end] : spans) text.recorded.push_back({begin, end, sound});
    const auto heard = [](std::string words) {
        std::erase_if(words, [](char c) { return std::string_view(" .,!").find(c) < 4; });
        return words;
    };
    std::string said;
    for (const SpeechPiece& piece : pieces_of(text)) said += piece.words;
    RC_ASSERT(heard(said) == heard(text.words));
}

TEST(Recording, IsAsLoudAsTheVoiceWhateverItsOwnLevel) {
    for (const double amplitude : {0.9, 0.3, 0.05}) {
        auto samples = tone(amplitude, 1.0);
        samples.resize(5 * samples.size());  // four seconds of silence
        const VoiceRecording recording = recording_of(samples);
        EXPECT_NEAR(speech_level_dB(samples), 20.0 * std::log10(amplitude), 0.3) << amplitude;
        const double heard_dB = 20.0 * std::log10(amplitude * static_cast<double>(recording.gain));
        EXPECT_NEAR(heard_dB, -speech_below_full_dB, 0.3) << amplitude;
    }
}

TEST(Recording, OfNoiseOrSilenceIsNotMadeLoud) {
    const VoiceRecording silence = recording_of(std::vector<std::int16_t>(4800));
    const VoiceRecording nothing = recording_of({});
    const VoiceRecording hiss = recording_of(tone(0.0003, 1.0));
    for (const VoiceRecording& each : {silence, nothing, hiss})
        EXPECT_FLOAT_EQ(each.gain, 10.0F) << "20 dB at most";
}

TEST(Recording, OfMoreThanANameIsNotHeardInARow) {
    EXPECT_NE(if_short(some_recording(5.0)), nullptr);
    EXPECT_EQ(if_short(some_recording(5.01)), nullptr);
    EXPECT_EQ(if_short(nullptr), nullptr);
}

}  // namespace
}  // namespace touchline
