#include "audio-cues/synth/mixer.h"
#include "tests/haptics/call_counts.h"

#include <array>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

TEST(MixerCalls, RenderingNeitherAllocatesNorLocks) {
    const auto mixer = std::make_unique<Mixer>();
    const std::vector<float> speech(128, 0.5F);
    Earcon earcon;
    earcon.note_count = 2;
    std::array<StereoFrame, block_frames> block;
    const CallCounter counting;
    (void)take_call_counts();
    for (int i = 0; i < 2000; ++i) {
        (void)mixer->speech().write(speech);
        if (i % 7 == 0)
            mixer->send({mixer->now() + i % 300, PlayEarcon{earcon, 0.5, 0.2, i % 2 == 0}});
        if (i % 11 == 0) mixer->send({0, SetContinuous{{.level = 0.3, .pulse_Hz = 5.0}}});
        if (i % 100 == 0) mixer->send({0, SetOutput{0.5, 0.9, i % 200 == 0}});
        if (i % 150 == 0) mixer->speech().cut();
        mixer->render(block);
    }
    const CallCounts counts = take_call_counts();
    EXPECT_EQ(counts.allocations, 0U);
    EXPECT_EQ(counts.locks, 0U);
}

}  // namespace
}  // namespace touchline
