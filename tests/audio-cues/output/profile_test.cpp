#include "audio-cues/output/outputs.h"
#include "tests/audio-cues/spectrum.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::array kinds{OutputKind::headset, OutputKind::speaker};

TEST(Profile, TheDefaultsKeepTheRules) {
    for (const OutputKind kind : kinds) {
        const auto kept = check(default_output(kind));
        EXPECT_TRUE(kept) << kept.error().line;
    }
}

TEST(Profile, VO1_StepsAreTenDecibelsAtMostOverEighteenAndTheirEndsAreTold) {
    for (const OutputKind kind : kinds) {
        const OutputProfile profile = default_output(kind);
        std::vector<double> levels_dB;
        std::size_t step = 0;
        EXPECT_TRUE(change_volume(profile, 0, -1).is_at_end);
        while (true) {
            levels_dB.push_back(dB_of_gain(output_of(profile, step).gain));
            const VolumeChange up = change_volume(profile, step, +1);
            if (up.is_at_end) break;
            EXPECT_EQ(up.step, step + 1);
            step = up.step;
        }
        for (std::size_t i = 1; i < levels_dB.size(); ++i) {
            EXPECT_GT(levels_dB[i], levels_dB[i - 1]);
            EXPECT_LE(levels_dB[i] - levels_dB[i - 1], 10.0);
        }
        EXPECT_GE(levels_dB.back() - levels_dB.front(), 18.0);
        EXPECT_EQ(change_volume(profile, 99, +1).step, step) << "clamped";
        EXPECT_EQ(change_volume(profile, step, -1).step, step - 1);
    }
}

TEST(Profile, VO3_HeadsetAndSpeakerHaveTheirOwnLevelsAndTheMixerKeepsEachCap) {
    const OutputProfile headset = default_output(OutputKind::headset);
    OutputProfile speaker = default_output(OutputKind::speaker);
    EXPECT_NE(output_of(headset, 3).gain, output_of(speaker, 3).gain);
    EXPECT_NE(output_of(headset, 3).cap, output_of(speaker, 3).cap);
    speaker.cap_dB = 80.0;
    for (const OutputProfile& profile : {headset, speaker}) {
        Mixer mixer;
        const SetOutput output = output_of(profile, 99);
        mixer.send({0, output});
        mixer.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 1.0, .pan = 1.0}}});
        const std::vector<float> speech(20000, 1.0F);
        (void)mixer.speech().write(speech);
        const auto out = rendered(mixer, 24000);
        const auto cap = static_cast<float>(output.cap);
        EXPECT_LE(peak(left_of_stereo(out)), cap);
        EXPECT_LE(peak(right_of_stereo(out)), cap);
        // The cap as it is heard: a sine of that peak against a full one in the middle.
        EXPECT_NEAR(profile.full_scale_dB + 3.01 + dB_of_gain(output.cap), profile.cap_dB, 0.01);
    }
}

TEST(Profile, ACalibratedOutputGivesSpeechItsLevel) {
    OutputProfile profile = default_output(OutputKind::headset);
    const double before_dB = dB_of_gain(output_of(profile, default_volume(profile)).gain);
    EXPECT_EQ(level_dB_of(profile, default_volume(profile)), 65.0);
    EXPECT_NEAR(before_dB, 65.0 - 110.0 + 18.8, 1e-9);
    profile.full_scale_dB += 7.0;  // a louder headset
    EXPECT_NEAR(dB_of_gain(output_of(profile, default_volume(profile)).gain), before_dB - 7.0,
                1e-9);
}

TEST(Profile, VO4_ALoudRoomNeedsTwentyDecibelsMore) {
    OutputProfile profile = default_output(OutputKind::headset);
    profile.ambient_dB = 60.0;
    EXPECT_TRUE(check(profile)) << "80 dB reach that";
    profile.ambient_dB = 61.0;
    EXPECT_FALSE(check(profile));
    profile.loudest_dB = 85.0;
    EXPECT_TRUE(check(profile));
    profile.ambient_dB = 45.0;
    profile.loudest_dB = 70.0;
    EXPECT_TRUE(check(profile)) << "a quiet room needs no more";
}

TEST(Profile, EveryRuleThatIsBrokenIsOneClearLine) {
    const auto broken = [](auto change) {
        OutputProfile profile = default_output(OutputKind::speaker);
        change(profile);
        const auto kept = check(profile);
        return !kept && !kept.error().line.empty() &&
               kept.error().line.find('\n') == std::string::npos;
    };
    EXPECT_TRUE(broken([](OutputProfile& p) { p.step_dB = 7.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.step_dB = 0.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.quietest_dB = 60.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.loudest_dB = 64.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.default_dB = 70.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.default_dB = 62.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.cap_dB = 70.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.cap_dB = 96.0; }));
    EXPECT_TRUE(broken([](OutputProfile& p) { p.cap_dB = std::nan(""); }));
    EXPECT_TRUE(
        broken([](OutputProfile& p) { p.step_dB = std::numeric_limits<double>::infinity(); }));
    EXPECT_FALSE(broken([](OutputProfile&) {}));
}

}  // namespace
}  // namespace touchline
