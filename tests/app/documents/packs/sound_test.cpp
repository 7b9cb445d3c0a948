// Tests untrusted recordings with the worker.
#include "app/documents/packs/unpacking.h"
#include "audio-cues/words/language.h"
#include "tests/app/documents/decode/liar_in_place.h"
#include "tests/app/documents/packs/made_packs.h"
#include "tests/config/mutated.h"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>
#include <sndfile.h>

namespace touchline {
namespace {

/// Returns the amplitude at 440 Hz, and the root mean square of everything.
std::pair<double, double> heard(const std::vector<std::int16_t>& samples) {
    std::complex<double> sum = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double phase = 2.0 * 3.14159265358979 * 440.0 * static_cast<double>(i) / 48000.0;
        const double sample = of_full_scale(samples[i]);
        sum += sample * std::polar(1.0, -phase);
        square += sample * sample;
    }
    const auto count = static_cast<double>(samples.size());
    return {2.0 * std::abs(sum) / count, std::sqrt(square / count)};
}

TEST(Sound, OfEveryFormAndRateIsTheSameTone) {
    const int forms[]{SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_WAV | SF_FORMAT_FLOAT,
                      SF_FORMAT_FLAC | SF_FORMAT_PCM_16, SF_FORMAT_OGG | SF_FORMAT_VORBIS};
    for (const int form : forms) {
        for (const int rate_Hz : {8000, 11025, 16000, 22050, 44100, 48000, 96000}) {
            for (const int channels : {1, 2}) {
                const auto bytes = made::recording(form, rate_Hz, 0.5, channels);
                const auto sound = open_sound({"a.ogg", bytes});
                ASSERT_TRUE(sound.has_value())
                    << form << ' ' << rate_Hz << sentence_of(sound.error(), Language());
                EXPECT_NEAR(static_cast<double>(sound->recording.samples.size()), 24000.0, 6.0)
                    << rate_Hz;
                const auto [tone, rms] = heard(sound->recording.samples);
                EXPECT_NEAR(tone, 0.5, 0.015) << form << ' ' << rate_Hz;
                EXPECT_NEAR(rms, 0.5 / std::sqrt(2.0), 0.015) << form << ' ' << rate_Hz;
                EXPECT_TRUE(sound->findings.empty());
            }
        }
    }
}

FindingKind refusal_of(const made::Bytes& bytes) {
    const auto sound = open_sound({"a.ogg", bytes});
    EXPECT_FALSE(sound.has_value());
    if (sound) return FindingKind::quiet_sound;
    EXPECT_EQ(sound.error().file, "a.ogg");
    return sound.error().kind;
}

TEST(Sound, ThatCannotBeUsedIsRefused) {
    const int wav = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
    EXPECT_EQ(refusal_of(made::bytes_of("no sound")), FindingKind::sound_unknown);
    EXPECT_EQ(refusal_of(made::recording(SF_FORMAT_AIFF | SF_FORMAT_PCM_16, 8000, 0.1)),
              FindingKind::sound_unknown);
    EXPECT_EQ(refusal_of(made::recording(wav, 8000, 61.0)), FindingKind::sound_long);
    EXPECT_EQ(refusal_of(made::recording(wav, 4000, 0.1)), FindingKind::sound_form);
    EXPECT_EQ(refusal_of(made::recording(wav, 8000, 0.1, 3)), FindingKind::sound_form);
    EXPECT_EQ(refusal_of(made::recording(wav, 8000, 0.0)), FindingKind::sound_broken);
}

TEST(Sound, ThatIsQuietIsTaken) {
    const auto sound = open_sound(
        {"a.wav", made::recording(SF_FORMAT_WAV | SF_FORMAT_PCM_16, 48000, 0.1, 1, 0.01F)});
    ASSERT_TRUE(sound.has_value());
    ASSERT_EQ(sound->findings.size(), 1U);
    EXPECT_EQ(sound->findings[0].kind, FindingKind::quiet_sound);
}

void expect_sound_or_sentence(const std::string& name, const made::Bytes& bytes, bool is_ogg) {
    std::mt19937 random(2026);
    ASSERT_GT(bytes.size(), 1000U);
    const int count = made::mutation_count(40);
    int taken = 0;
    for (int i = 0; i < count; ++i) {
        auto changed = mutated(bytes, random);
        // Otherwise libogg would drop every damaged page, and nothing else would be tested.
        if (is_ogg) made::mend_ogg_sums(changed);
        const auto sound = open_sound({name, changed});
        taken += sound ? 1 : 0;
        ASSERT_TRUE(sound || is_one_sentence(sentence_of(sound.error(), Language()))) << i;
        if (!sound) continue;
        ASSERT_LE(length_s(sound->recording), pack_limits.sound_s + 0.001) << i;
        ASSERT_TRUE(std::isfinite(sound->recording.gain) && sound->recording.gain > 0.0F) << i;
    }
    EXPECT_FALSE(has_a_child());
    std::printf("%s: %d of %d taken\n", name.c_str(), taken, count);
}

TEST(Mutations, OfRecordingsAreSoundOrOneSentence) {
    expect_sound_or_sentence("a.ogg", made::ogg(), true);
    expect_sound_or_sentence("a.opus", made::recording(SF_FORMAT_OGG | SF_FORMAT_OPUS, 48000, 0.4),
                             true);
    expect_sound_or_sentence("a.flac",
                             made::recording(SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 44100, 0.4), false);
    expect_sound_or_sentence("a.wav", made::recording(SF_FORMAT_WAV | SF_FORMAT_PCM_16, 8000, 0.4),
                             false);
}

}  // namespace
}  // namespace touchline
