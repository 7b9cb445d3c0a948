#include "audio-cues/speech/speech_input.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(SpeechText, OrdersAndBrokenCharactersBecomeBlanks) {
    EXPECT_EQ(plain_text("a\x01"
                         "80S b\n"),
              "a 80S b ");
    EXPECT_EQ(plain_text("Tür – größer"), "Tür – größer");
    EXPECT_EQ(plain_text("a\xff"
                         "b\xc3"),
              "a b ");
    EXPECT_EQ(plain_text("\xc2\x85x"), " x");
    EXPECT_EQ(plain_text("<speak>[[h@l'oU]]"), "<speak>[[h@l'oU]]");
}

TEST(SpeechText, ALongTextIsCutBetweenCharacters) {
    std::string text;
    for (int i = 0; i < 3000; ++i) text += "é";
    const std::string cut = plain_text("a" + text);
    EXPECT_EQ(cut.size(), 3999U);
    EXPECT_EQ(plain_text(cut), cut);
}

TEST(SpeechRate, StepsRiseAndTheSlowOnesAreMadeByPauses) {
    EngineRate last{0, 100};
    for (std::size_t step = 0; step < speech_rates_per_minute.size(); ++step) {
        const EngineRate rate = engine_rate(step, 1.0);
        EXPECT_TRUE(rate.words_per_minute > last.words_per_minute || rate.word_gap < last.word_gap);
        EXPECT_GE(rate.words_per_minute, 80);
        EXPECT_LE(rate.words_per_minute, 450);
        EXPECT_EQ(rate.word_gap > 0, speech_rates_per_minute[step] < 100.0);
        last = rate;
    }
    EXPECT_EQ(engine_rate(99, 1.0).words_per_minute, engine_rate(6, 1.0).words_per_minute);
    EXPECT_EQ(engine_rate(3, std::nan("")).words_per_minute, engine_rate(3, 1.0).words_per_minute);
}

}  // namespace
}  // namespace touchline
