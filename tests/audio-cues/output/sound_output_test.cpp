#include "audio-cues/output/sound_output.h"

#include "tests/audio-cues/spectrum.h"

#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// A sound card that the test controls.
struct Card {
    bool is_there = true;
    bool is_gone = false;
    int opened = 0;
    int block = 0;
    FrameSource source;  // set while open
};

class TestDevice final : public SoundDevice {
  public:
    explicit TestDevice(Card& card) : card_(card) {}

    Result<void> open(FrameSource source, int block) override {
        if (!card_.is_there) return failure("no card");
        card_.source = std::move(source);
        card_.block = block;
        ++card_.opened;
        return {};
    }

    void close() override { card_.source = nullptr; }

    [[nodiscard]] bool is_gone() const override { return card_.is_gone; }

  private:
    Card& card_;
};

class SoundOutputTest : public testing::Test {
  protected:
    /// Steps 16 ms, six blocks, or one and a half of the long ones in the mean; the card asks for
    /// them if it plays.
    void step(bool plays = true) {
        output_.step();
        now_ns_ += 16'000'000;
        owed_ += 6 * block_frames;
        while (plays && card_.source && owed_ >= card_.block) {
            std::vector<StereoFrame> frames(static_cast<std::size_t>(card_.block));
            card_.source(frames);
            owed_ -= card_.block;
            for (const StereoFrame& frame : frames) heard_.push_back(frame.left);
        }
        if (!plays || !card_.source) owed_ = 0;
    }

    void steps(int count, bool plays = true) {
        for (int i = 0; i < count; ++i) step(plays);
    }

    Card card_;
    Mixer mixer_;
    std::int64_t now_ns_ = 1'000'000'000;
    int owed_ = 0;  // frames that the card has not asked for yet
    std::vector<float> heard_;
    SoundOutput output_{std::make_unique<TestDevice>(card_), mixer_, [this] { return now_ns_; }};
};

TEST_F(SoundOutputTest, PlaysWhatTheMixerRenders) {
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.5}}});
    steps(10);
    EXPECT_TRUE(output_.is_working());
    EXPECT_EQ(output_.problem(), "");
    EXPECT_EQ(heard_.size(), 10U * 768U);
    EXPECT_GT(peak(heard_), 0.3F);
}

TEST_F(SoundOutputTest, WithoutACardEverythingElseGoesOnAndSoundComesByItself) {
    card_.is_there = false;
    const std::vector<float> speech(24000, 0.5F);
    (void)mixer_.speech().write(speech);
    steps(63);  // one second
    EXPECT_FALSE(output_.is_working());
    EXPECT_EQ(output_.problem(), "no card");
    EXPECT_EQ(mixer_.speech().waiting(), 0U) << "half a second of speech came to its end";
    EXPECT_NEAR(static_cast<double>(mixer_.now()), 62.0 * 768.0, 256.0) << "at its pace";
    card_.is_there = true;
    steps(130);
    EXPECT_TRUE(output_.is_working());
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.5}}});
    heard_.clear();
    steps(5);
    EXPECT_GT(peak(heard_), 0.3F);
}

TEST_F(SoundOutputTest, UnpluggedIsNoticedAtOnceAndTriedEveryTwoSeconds) {
    steps(10);
    card_.is_gone = true;
    card_.is_there = false;
    step();
    EXPECT_FALSE(output_.is_working());
    EXPECT_EQ(output_.problem(), "The sound device was unplugged.");
    card_.is_gone = false;
    steps(120);
    EXPECT_EQ(card_.opened, 1);
    card_.is_there = true;
    steps(130);
    EXPECT_EQ(card_.opened, 2);
    EXPECT_TRUE(output_.is_working());
}

TEST_F(SoundOutputTest, ACardThatStandsStillIsLostAfterHalfASecond) {
    steps(10);
    steps(30, false);
    EXPECT_TRUE(output_.is_working());
    steps(3, false);
    EXPECT_FALSE(output_.is_working());
    EXPECT_EQ(output_.problem(), "The sound device stands still.");
    const FrameTime stood = mixer_.now();
    steps(10, false);
    EXPECT_GT(mixer_.now(), stood + 9 * 768 - 256) << "to nowhere, so that speech ends";
    steps(120);
    EXPECT_TRUE(output_.is_working());
    EXPECT_EQ(card_.opened, 2);
}

TEST_F(SoundOutputTest, ACallerThatWasAwayIsNotMadeToRenderHours) {
    card_.is_there = false;
    step();
    now_ns_ += std::int64_t{3600} * 1'000'000'000;
    const FrameTime before = mixer_.now();
    step();
    EXPECT_LE(mixer_.now() - before, frame_rate_Hz);
}

TEST_F(SoundOutputTest, StampsFollowTheMixer) {
    steps(20);
    EXPECT_NEAR(static_cast<double>(output_.clock().frame_at(now_ns_)),
                static_cast<double>(mixer_.now() + FrameClock::lead_frames), 800.0);
}

TEST_F(SoundOutputTest, RestsInLongBlocksAfterASecondOfSilenceAndEndsTheRestInAnother) {
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.5}}});
    steps(10);
    output_.rest(true);
    steps(130);
    EXPECT_EQ(card_.block, block_frames) << "not while anything sounds";
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.0}}});
    steps(62);  // within a second, for the tone takes a moment to end
    EXPECT_EQ(card_.block, block_frames);
    steps(20);
    EXPECT_EQ(card_.block, resting_block_frames);
    output_.rest(false);
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.5}}});
    heard_.clear();
    steps(2);
    EXPECT_GT(peak(heard_), 0.1F) << "what comes is heard at once, before the blocks are short";
    EXPECT_EQ(card_.block, resting_block_frames);
    mixer_.send({0, SetContinuous{{.frequency_Hz = 300.0, .level = 0.0}}});
    steps(82);
    EXPECT_EQ(card_.block, block_frames);
    EXPECT_EQ(card_.opened, 3);
    EXPECT_TRUE(output_.is_working());
}

TEST_F(SoundOutputTest, ACardThatIsTakenAtTheChangeIsTriedAgain) {
    steps(10);
    output_.rest(true);
    card_.is_there = false;
    const FrameTime before = mixer_.now();
    steps(70);
    EXPECT_FALSE(output_.is_working());
    EXPECT_EQ(output_.problem(), "no card");
    EXPECT_NEAR(static_cast<double>(mixer_.now() - before), 70.0 * 768.0, 1024.0) << "at its pace";
    card_.is_there = true;
    steps(130);
    EXPECT_TRUE(output_.is_working());
    EXPECT_EQ(card_.block, resting_block_frames);
}

}  // namespace
}  // namespace touchline
