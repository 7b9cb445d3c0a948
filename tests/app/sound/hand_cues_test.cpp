#include "app/sound/sound_loop.h"
#include "audio-cues/cues/cue_table.h"
#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr std::int64_t us = 1'000;
constexpr double device_periods = 2.0;

ContactEvent touch_at(double time_s, double x_m = 0.0) {
    ContactEvent event;
    event.kind = ContactEventKind::contact_made;
    event.time_s = time_s;
    event.place_W = {x_m, 0.0};
    return event;
}

TEST(ServoClock, TheQuickestReportDecides) {
    ServoClock clock;
    EXPECT_EQ(clock.ns_of(1.0), std::nullopt);
    clock.told(1.000, 5'004'000'000);
    clock.told(1.001, 5'001'500'000);
    clock.told(1.002, 5'009'000'000);
    EXPECT_NEAR(static_cast<double>(*clock.ns_of(1.002)), 5.0025e9, 1e3);
    clock.told(1.002, 9'000'000'000);  // the same report, much later
    EXPECT_NEAR(static_cast<double>(*clock.ns_of(1.002)), 5.0025e9, 1e3);
}

TEST(ServoClock, AnotherServoBeginsAnew) {
    ServoClock clock;
    clock.told(100.0, 1'000'000'000);
    clock.told(0.001, 9'000'000'000);
    EXPECT_NEAR(static_cast<double>(*clock.ns_of(0.001)), 9e9, 1.0);
    clock.told(std::nan(""), 1);
    EXPECT_NEAR(static_cast<double>(*clock.ns_of(0.001)), 9e9, 1.0);
    EXPECT_EQ(clock.ns_of(std::nan("")), std::nullopt);
}

TEST(ServoClock, FollowsAClockThatIsSlower) {
    ServoClock clock;
    for (int i = 0; i < 60 * 600; ++i) {
        const double servo_s = i / 60.0;
        clock.told(servo_s, std::llround(1e9 * servo_s * 1.00005));
    }
    EXPECT_NEAR(static_cast<double>(*clock.ns_of(600.0)), 600.03e9, 2e6);
}

/// A servo, the sound loop and a device on one virtual clock; each sample is heard when the device,
/// which holds two periods, has played it.
class Chain {
  public:
    Chain() {
        for (std::int64_t i = 0; i < 400; ++i) render_block();
        setting_.clock.told(0.0, now_ns());
        servo_start_ns_ = now_ns();
    }

    /// Returns the time from the event at `phase_us` in a block, which the loop reads
    /// `read_after_us` later, to the first sample at the ear.
    double latency_s(std::int64_t phase_us, std::int64_t read_after_us) {
        for (int i = 0; i < 40; ++i) render_block();  // by then the last sound is over
        const std::int64_t event_ns = now_ns() + phase_us * us;
        const double event_s = 1e-9 * static_cast<double>(event_ns - servo_start_ns_);
        const std::int64_t read_ns = event_ns + read_after_us * us;
        while (now_ns() <= read_ns) render_block();
        cues_.play(touch_at(event_s), setting_);
        for (int i = 0; i < 20; ++i) {
            const FrameTime first = mixer_.now();
            const auto sound = render_block();
            const auto heard = std::find_if(sound.begin(), sound.end(), [](const auto& frame) {
                return frame.left != 0.0F || frame.right != 0.0F;
            });
            if (heard == sound.end()) continue;
            const auto frame = first + (heard - sound.begin());
            const double played_s =
                static_cast<double>(frame + block_frames) / frame_rate_Hz;  // one period waits
            return played_s - 1e-9 * static_cast<double>(event_ns);
        }
        return 1.0;
    }

  private:
    [[nodiscard]] std::int64_t now_ns() const {
        return std::llround(1e9 * static_cast<double>(mixer_.now()) / frame_rate_Hz);
    }

    std::array<StereoFrame, block_frames> render_block() {
        clock_.told(mixer_.now(), now_ns());
        std::array<StereoFrame, block_frames> frames;
        mixer_.render(frames);
        return frames;
    }

    Mixer mixer_;
    FrameClock clock_;
    HandCues cues_{mixer_, clock_};
    CueSetting setting_;
    std::int64_t servo_start_ns_ = 0;
};

/// One tick, one block and two device periods.
TEST(HandCues, FromTheTickToTheEarInTenMilliseconds) {
    constexpr double block_s = static_cast<double>(block_frames) / frame_rate_Hz;
    Chain chain;
    double slowest_s = 0.0;
    double quickest_s = 1.0;
    for (std::int64_t phase_us = 0; phase_us < 2667; phase_us += 111) {
        const double latency_s = chain.latency_s(phase_us, 1000);
        slowest_s = std::max(slowest_s, latency_s);
        quickest_s = std::min(quickest_s, latency_s);
    }
    constexpr double tick_s = 1e-3;
    EXPECT_LE(tick_s + slowest_s, tick_s + block_s + device_periods * block_s);
    EXPECT_LE(tick_s + slowest_s, 0.010);
    EXPECT_GT(quickest_s, block_s) << "or the device would play what it does not have";
    EXPECT_LE(slowest_s - quickest_s, block_s) << "a click is heard within a block of its time";
}

TEST(HandCues, WithoutAClockASoundComesAtOnce) {
    Mixer mixer;
    const FrameClock clock;
    HandCues cues(mixer, clock);
    cues.play(touch_at(123.0), {});
    EXPECT_GT(peak(left_of_stereo(rendered(mixer, 4800))), 0.01F);
}

TEST(HandCues, AreHeardWhereTheHandIsAndNotAtAllWhereSoundsAreOff) {
    Mixer mixer;
    const FrameClock clock;
    HandCues cues(mixer, clock);
    CueSetting setting;
    setting.area = {0.05, 0.05};
    cues.play(touch_at(1.0, -0.05), setting);
    const auto left = rendered(mixer, 4800);
    EXPECT_GT(rms(left_of_stereo(left)), 4.0 * rms(right_of_stereo(left)));
    setting.amount = CueAmount::none;
    cues.play(touch_at(2.0), setting);
    EXPECT_EQ(peak(left_of_stereo(rendered(mixer, 4800))), 0.0F);
}

TEST(PollPace, LooksRarelyWhereTheHandHasToldNothingForHalfAMinute) {
    constexpr std::int64_t second_ns = 1'000'000'000;
    PollPace pace;
    EXPECT_EQ(pace.wait_us(false, 0), 1000);
    EXPECT_EQ(pace.wait_us(false, 30 * second_ns), 1000);
    EXPECT_EQ(pace.wait_us(false, 31 * second_ns), 20'000);
    EXPECT_EQ(pace.wait_us(true, 32 * second_ns), 1000);
    EXPECT_EQ(pace.wait_us(false, 62 * second_ns), 1000);
}

}  // namespace
}  // namespace touchline
