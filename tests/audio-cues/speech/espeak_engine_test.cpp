#include "audio-cues/speech/espeak_engine.h"

#include "audio-cues/output/outputs.h"
#include "audio-cues/speech/recording.h"
#include "audio-cues/words/language.h"
#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::vector<std::int16_t> said(EspeakEngine& engine, const std::string& text,
                               const EngineRate& rate = {}) {
    std::vector<std::int16_t> all;
    engine.speak(text, rate, [&all](std::span<const std::int16_t> samples) {
        all.insert(all.end(), samples.begin(), samples.end());
        return true;
    });
    return all;
}

/// These are not the sentences that the rates were measured with.
const std::map<std::string, std::string> reading{
    {"en",
     "This picture is a house with a garden. The handle is on the left wall now. Move up to "
     "reach the roof, or down to find the door. There are two windows between them. A fence "
     "runs along the bottom. If you lose the line, wait for the sound that leads you back."},
    {"de",
     "Dieses Bild ist ein Haus mit einem Garten. Der Griff ist jetzt an der linken Wand. Gehen "
     "Sie hinauf zum Dach oder hinunter zur Tür. Dazwischen liegen zwei Fenster. Ein Zaun läuft "
     "unten entlang. Wenn Sie die Linie verlieren, warten Sie auf den Ton, der Sie führt."},
    {"fr",
     "Cette image est une maison avec un jardin. La poignée est maintenant sur le mur de gauche. "
     "Montez pour atteindre le toit ou descendez pour trouver la porte. Entre les deux il y a "
     "deux fenêtres. Une clôture longe le bas. Si vous perdez la ligne, attendez le son."},
    {"es",
     "Esta imagen es una casa con un jardín. El mango está ahora en la pared izquierda. Suba "
     "para llegar al tejado o baje para encontrar la puerta. Entre ellos hay dos ventanas. Una "
     "valla corre por abajo. Si pierde la línea, espere el sonido que le guía de vuelta."},
    {"it",
     "Questa immagine è una casa con un giardino. L’impugnatura è ora sul muro di sinistra. Salire "
     "per arrivare al tetto o scendere per trovare la porta. Tra i due ci sono due finestre. Una "
     "siepe corre lungo il basso. Se si perde la linea, aspettare il suono che riporta indietro."}};

double words_per_minute(EspeakEngine& engine, const std::string& text, const EngineRate& rate) {
    std::istringstream stream(text);
    int words = 0;
    for (std::string word; stream >> word;) ++words;
    const double minutes =
        static_cast<double>(said(engine, text, rate).size()) / EspeakEngine::rate_Hz / 60.0;
    return words / minutes;
}

TEST(EspeakEngine, SP6_SevenRatesInEveryLanguageAreWithinTenPercent) {
    for (const auto& [code, text] : reading) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language);
        auto engine = EspeakEngine::start(language->voice());
        ASSERT_TRUE(engine) << engine.error().line;
        double last = 0.0;
        for (std::size_t step = 0; step < speech_rates_per_minute.size(); ++step) {
            const double measured =
                words_per_minute(*engine, text, engine_rate(step, language->pace()));
            const double wanted = speech_rates_per_minute[step];
            EXPECT_NEAR(measured / wanted, 1.0, 0.10) << code << " " << wanted << ": " << measured;
            EXPECT_GT(measured, last);
            last = measured;
            RecordProperty(code + std::to_string(step), std::to_string(measured));
        }
    }
}

/// What the operator measures is of the voice; recordings are made as loud as it.
TEST(EspeakEngine, EveryVoiceIsAsLoudAsRecordingsAreMade) {
    for (const auto& [code, text] : reading) {
        auto engine = EspeakEngine::start(Language::load(TOUCHLINE_CATALOGUES, code)->voice());
        ASSERT_TRUE(engine) << engine.error().line;
        EXPECT_NEAR(speech_level_dB(said(*engine, text)), -speech_below_full_dB, 2.5) << code;
    }
}

/// The voice's pitch: the median over all windows of the strongest repetition between 60 and 250
/// Hz.
double pitch_Hz(const std::vector<std::int16_t>& samples) {
    std::vector<double> found;
    for (std::size_t start = 0; start + 2048 < samples.size(); start += 1024) {
        double power = 0.0;
        for (std::size_t i = 0; i < 1024; ++i) power += std::pow(double(samples[start + i]), 2);
        double best = 0.5 * power;  // otherwise it is not a vowel
        std::size_t best_lag = 0;
        for (std::size_t lag = 88; lag < 367; ++lag) {
            double sum = 0.0;
            for (std::size_t i = 0; i < 1024; ++i) {
                sum += double(samples[start + i]) * double(samples[start + i + lag]);
            }
            if (sum > best) {
                best = sum;
                best_lag = lag;
            }
        }
        if (best_lag > 0 && power > 1e9) found.push_back(22050.0 / double(best_lag));
    }
    std::sort(found.begin(), found.end());
    return found.empty() ? 0.0 : found[found.size() / 2];
}

TEST(EspeakEngine, SP6_TheRateLeavesThePitch) {
    auto engine = EspeakEngine::start("en");
    ASSERT_TRUE(engine);
    const std::string& text = reading.at("en");
    const double slow_Hz = pitch_Hz(said(*engine, text, engine_rate(0, 1.0)));
    const double fast_Hz = pitch_Hz(said(*engine, text, engine_rate(6, 1.0)));
    EXPECT_GT(slow_Hz, 60.0);
    EXPECT_NEAR(fast_Hz / slow_Hz, 1.0, 0.10) << slow_Hz << " " << fast_Hz;
}

TEST(EspeakEngine, MarkupAndPhonemesAreTextAndOrdersAreNone) {
    auto engine = EspeakEngine::start("en");
    ASSERT_TRUE(engine);
    const auto plain = said(*engine, "b");
    EXPECT_GT(said(*engine, "<break time=\"9s\"/> b").size(), plain.size());
    EXPECT_LT(said(*engine, "<break time=\"9s\"/> b").size(), 9U * 22050U) << "no pause of 9 s";
    EXPECT_GT(said(*engine, "[[h@l'oU]]").size(), said(*engine, "hello").size() * 3 / 2)
        << "spelled";
    const std::string rest = "450S this sentence would be three times as fast.";
    EXPECT_NEAR(static_cast<double>(said(*engine, "\x01" + rest).size()),
                static_cast<double>(said(*engine, " " + rest).size()), 2205.0)
        << "no order to the engine";
}

TEST(EspeakEngine, TheSinkStopsItAtOnce) {
    auto engine = EspeakEngine::start("en");
    ASSERT_TRUE(engine);
    int pieces = 0;
    engine->speak(reading.at("en"), {}, [&pieces](std::span<const std::int16_t> samples) {
        EXPECT_LE(samples.size(), 1103U);  // 50 ms
        return ++pieces < 5;
    });
    EXPECT_EQ(pieces, 5);
    EXPECT_GT(said(*engine, "again").size(), 1000U);
}

TEST(EspeakEngine, AVoiceThatIsNoneIsOneLine) {
    EXPECT_FALSE(EspeakEngine::start("xx-none"));
}

}  // namespace
}  // namespace touchline
