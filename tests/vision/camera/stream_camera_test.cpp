// The real code from the port on, on virtual time, with cameras that can do little and behave
// badly.
#include "vision/camera/stream_camera.h"

#include "tests/vision/camera/fake_port.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using enum PixelFormat;

TEST(StreamChoice, PreviewIsTheSmallestThatIsEnoughAndCheapest) {
    const CameraAbilities abilities{{{mjpeg, {4000, 3000}},
                                     {mjpeg, {640, 480}},
                                     {yuyv, {640, 480}},
                                     {yuyv, {1280, 720}},
                                     {yuyv, {320, 240}}},
                                    false,
                                    false,
                                    false};
    EXPECT_EQ(preview_mode(abilities), (StreamMode{yuyv, {640, 480}}));
    EXPECT_EQ(still_mode(abilities), (StreamMode{mjpeg, {4000, 3000}}));
}

TEST(StreamChoice, WhereNoneIsEnoughTheLargestIsThePreview) {
    const CameraAbilities abilities{
        {{yuyv, {160, 120}}, {mjpeg, {352, 288}}, {yuyv, {352, 288}}}, false, false, false};
    EXPECT_EQ(preview_mode(abilities), (StreamMode{yuyv, {352, 288}}));
}

TEST(StreamChoice, NothingFromNothing) {
    EXPECT_FALSE(preview_mode({}));
    EXPECT_FALSE(still_mode({}));
}

using testing::FakeCamera;
using testing::FakePort;

constexpr double step_s = 1.0 / 60;
const cv::Size preview_size(640, 480);
const cv::Size still_size(1280, 960);

class Rig {
  public:
    explicit Rig(std::vector<FakeCamera> cameras) {
        auto fake = std::make_unique<FakePort>(std::move(cameras));
        port = fake.get();
        camera = std::make_unique<StreamCamera>(std::move(fake));
    }

    CameraView step() {
        port->now_s += step_s;
        CameraView view = camera->step(port->now_s);
        condition = view.condition;
        if (view.preview) preview = view.preview;
        if (view.still) stills.push_back(*view.still);
        given_up += view.has_given_up ? 1 : 0;
        return view;
    }

    void run(double seconds) {
        for (const double end_s = port->now_s + seconds; port->now_s < end_s;) (void)step();
    }

    /// Waits for the still or the refusal. Returns how long that took.
    double take_still() {
        const double start_s = port->now_s;
        const std::size_t before = stills.size() + given_up;
        camera->want_still();
        while (stills.size() + given_up == before && port->now_s < start_s + 60.0) (void)step();
        return port->now_s - start_s;
    }

    [[nodiscard]] std::ptrdiff_t count(const std::string& word) const {
        return std::count(port->log.begin(), port->log.end(), word);
    }

    [[nodiscard]] std::ptrdiff_t place(const std::string& word) const {
        return std::find(port->log.begin(), port->log.end(), word) - port->log.begin();
    }

    FakeCamera& fake(std::size_t i = 0) { return port->cameras[i]; }

    FakePort* port = nullptr;
    std::unique_ptr<StreamCamera> camera;
    CameraCondition condition = CameraCondition::absent;
    std::optional<cv::Mat> preview;
    std::vector<Still> stills;
    std::size_t given_up = 0;
};

TEST(StreamCameraTest, NoCameraAtAllIsOneClearSentence) {
    Rig rig({});
    rig.run(5.0);
    EXPECT_EQ(rig.condition, CameraCondition::absent);
    EXPECT_EQ(sentence(rig.condition), "There is no camera. Plug one in.");
    EXPECT_LT(rig.take_still(), 0.1);
    EXPECT_EQ(rig.given_up, 1U);
    EXPECT_TRUE(rig.port->log.empty());
}

TEST(StreamCameraTest, OneStreamIsReconfiguredForTheStillAndBack) {
    Rig rig({testing::usb_camera("a")});
    rig.run(1.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    ASSERT_TRUE(rig.preview);
    EXPECT_EQ(rig.preview->size(), preview_size);
    EXPECT_LT(rig.take_still(), 3.0);
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_EQ(rig.stills[0].frame.size, still_size);
    EXPECT_FALSE(rig.stills[0].is_blurred);
    EXPECT_FALSE(rig.stills[0].is_clipped);
    rig.run(1.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    const std::vector<std::string> expected{"open a",         "start 640x480", "lock",
                                            "start 1280x960", "free",          "start 640x480"};
    EXPECT_EQ(rig.port->log, expected);
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, APreviewLargerThanTheScreenNeedsIsScaled) {
    FakeCamera large = testing::usb_camera("a");
    large.abilities.modes = {{PixelFormat::mjpeg, still_size}};
    Rig rig({large});
    rig.run(1.0);
    ASSERT_TRUE(rig.preview);
    EXPECT_EQ(rig.preview->size(), preview_size);
    rig.take_still();
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_EQ(rig.stills[0].frame.size, still_size);
}

TEST(StreamCameraTest, TwoStreamsGiveTheStillWithoutAStop) {
    Rig rig({testing::board_camera("b")});
    rig.run(1.0);
    EXPECT_LT(rig.take_still(), 2.0);
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_EQ(rig.stills[0].frame.size, still_size);
    EXPECT_EQ(rig.count("start 640x480"), 1);
    EXPECT_LT(rig.place("focus"), rig.place("lock"));
    EXPECT_LT(rig.place("lock"), rig.place("free"));
    EXPECT_LT(rig.place("lock"), rig.place("unfocus"));
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, WithoutAnExposureLockTheLightIsWaitedFor) {
    FakeCamera camera = testing::usb_camera("a");
    camera.abilities.has_exposure_lock = false;
    camera.brightens_s = 0.8;
    Rig rig({camera});
    rig.run(2.0);
    EXPECT_GT(rig.take_still(), 0.8);
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_GT(rig.stills[0].quality.brightness, 100.0);
    EXPECT_EQ(rig.count("lock"), 0);
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, AFocusThatNeverComesIsGoneWithout) {
    FakeCamera camera = testing::board_camera("b");
    camera.focuses_s = 1e9;
    Rig rig({camera});
    rig.run(1.0);
    const double took_s = rig.take_still();
    EXPECT_GT(took_s, CaptureLimits{}.focus_s);
    EXPECT_LT(took_s, CaptureLimits{}.focus_s + 2.0);
    EXPECT_EQ(rig.stills.size(), 1U);
}

TEST(StreamCameraTest, WithoutAReportOfTheLoopsSteadyLightIsEnough) {
    FakeCamera camera = testing::board_camera("b");
    camera.tells_loops = false;
    Rig rig({camera});
    rig.run(1.0);
    EXPECT_LT(rig.take_still(), CaptureLimits{}.focus_s + 2.0);
    EXPECT_EQ(rig.stills.size(), 1U);
}

TEST(StreamCameraTest, SharpnessIsWaitedFor) {
    FakeCamera camera = testing::usb_camera("a");
    camera.sharpens_s = 0.35;  // after every start: the first three frames of the still are blurred
    Rig rig({camera});
    rig.run(1.0);
    rig.take_still();
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_FALSE(rig.stills[0].is_blurred);
    EXPECT_EQ(rig.count("lock"), 1);
}

TEST(StreamCameraTest, ABlurredStillIsTriedOnceMoreAndThenSaidToBeSo) {
    FakeCamera camera = testing::usb_camera("a");
    camera.is_never_sharp = true;
    Rig rig({camera});
    rig.run(1.0);
    EXPECT_LT(rig.take_still(), 8.0);
    ASSERT_EQ(rig.stills.size(), 1U);
    EXPECT_TRUE(rig.stills[0].is_blurred);
    EXPECT_EQ(rig.count("lock"), 2);
    EXPECT_EQ(rig.count("start 1280x960"), 1);
}

TEST(StreamCameraTest, AClippedStillIsTriedOnceMore) {
    for (const int clipped : {1, 5}) {
        for (FakeCamera camera : {testing::usb_camera("a"), testing::board_camera("b")}) {
            camera.clipped_stills = clipped;
            Rig rig({camera});
            rig.run(1.0);
            rig.take_still();
            ASSERT_EQ(rig.stills.size(), 1U);
            EXPECT_EQ(rig.stills[0].is_clipped, clipped > 1);
            EXPECT_EQ(rig.count("lock"), 2);
        }
    }
}

TEST(StreamCameraTest, UnpluggedAndPluggedInAgain) {
    Rig rig({testing::usb_camera("a")});
    rig.run(1.0);
    rig.fake().is_plugged = false;
    (void)rig.step();
    EXPECT_EQ(rig.condition, CameraCondition::absent);
    EXPECT_EQ(rig.count("close"), 1);
    EXPECT_FALSE(rig.camera->abilities());
    rig.run(5.0);
    rig.fake().is_plugged = true;
    rig.run(1.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    rig.take_still();
    EXPECT_EQ(rig.stills.size(), 1U);
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, UnpluggedDuringAStillGivesItUp) {
    for (const double when_s : {0.05, 0.35, 0.6, 0.9}) {
        Rig rig({testing::usb_camera("a")});
        rig.run(1.0);
        rig.camera->want_still();
        rig.run(when_s);
        if (!rig.stills.empty()) continue;
        rig.fake().is_plugged = false;
        rig.run(0.1);
        EXPECT_EQ(rig.given_up, 1U);
        rig.fake().is_plugged = true;
        rig.run(10.0);
        EXPECT_EQ(rig.given_up, 1U);
        EXPECT_TRUE(rig.stills.empty());
        EXPECT_EQ(rig.condition, CameraCondition::ready);
    }
}

TEST(StreamCameraTest, ADeadStreamGivesNoErrorAndIsNoticedByTime) {
    Rig rig({testing::usb_camera("a")});
    rig.run(1.0);
    rig.fake().is_dead = true;
    rig.run(CaptureLimits{}.stall_s - 0.2);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    rig.run(0.4);
    EXPECT_EQ(rig.condition, CameraCondition::stopped);
    EXPECT_EQ(sentence(rig.condition), "The camera gives no picture. Please call the staff.");
    EXPECT_EQ(rig.count("close"), 1);
    rig.run(30.0);
    EXPECT_EQ(rig.condition, CameraCondition::stopped);
    EXPECT_GE(rig.count("open a"), 3);
    rig.fake().is_dead = false;
    rig.run(12.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, DeadDuringAStillGivesItUp) {
    Rig rig({testing::usb_camera("a")});
    rig.run(1.0);
    rig.fake().is_dead = true;
    EXPECT_LT(rig.take_still(), 3.0);
    EXPECT_EQ(rig.given_up, 1U);
}

TEST(StreamCameraTest, ASecondStreamThatIsDeadAloneGivesTheStillUp) {
    FakeCamera camera = testing::board_camera("b");
    camera.is_still_dead = true;
    Rig rig({camera});
    rig.run(1.0);
    EXPECT_LT(rig.take_still(), 15.0);
    EXPECT_EQ(rig.given_up, 1U);
    rig.run(0.5);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
}

TEST(StreamCameraTest, FramesThatCannotBeReadAreNoFrames) {
    Rig rig({testing::usb_camera("a")});
    rig.fake().is_garbled = true;
    rig.run(CaptureLimits{}.start_s + 1.0);
    EXPECT_EQ(rig.condition, CameraCondition::stopped);
    EXPECT_FALSE(rig.preview);
}

TEST(StreamCameraTest, ACameraThatRefusesIsAskedAgain) {
    for (const bool refuses_open : {true, false}) {
        FakeCamera camera = testing::usb_camera("a");
        camera.refuses_open = refuses_open;
        camera.refuses_start = !refuses_open;
        Rig rig({camera});
        rig.run(5.0);
        EXPECT_EQ(rig.condition, CameraCondition::stopped);
        EXPECT_GE(rig.count("open a"), 2);
        EXPECT_LE(rig.count("open a"), 4);
        rig.fake().refuses_open = rig.fake().refuses_start = false;
        rig.run(4.0);
        EXPECT_EQ(rig.condition, CameraCondition::ready);
        EXPECT_EQ(rig.port->misuses, 0);
    }
}

TEST(StreamCameraTest, ACameraWithoutAKnownFormatIsNotUsed) {
    FakeCamera camera = testing::usb_camera("a");
    camera.abilities.modes.clear();
    Rig rig({camera});
    rig.run(5.0);
    EXPECT_EQ(rig.condition, CameraCondition::stopped);
    EXPECT_EQ(rig.count("start 640x480"), 0);
}

TEST(StreamCameraTest, OfSeveralTheChosenOneIsUsedAndNoOther) {
    Rig rig({testing::usb_camera("a"), testing::board_camera("b")});
    EXPECT_EQ(rig.camera->list().size(), 2U);
    rig.run(1.0);
    EXPECT_FALSE(rig.camera->abilities()->has_two_streams);
    rig.camera->choose("b");
    rig.run(1.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    EXPECT_TRUE(rig.camera->abilities()->has_two_streams);
    rig.fake(1).is_plugged = false;
    rig.run(3.0);
    EXPECT_EQ(rig.condition, CameraCondition::absent);
    rig.camera->choose("");
    rig.run(1.0);
    EXPECT_EQ(rig.condition, CameraCondition::ready);
    EXPECT_FALSE(rig.camera->abilities()->has_two_streams);
    EXPECT_EQ(rig.port->misuses, 0);
}

TEST(StreamCameraTest, ChoosingAnotherGivesTheStillUp) {
    Rig rig({testing::usb_camera("a"), testing::usb_camera("b")});
    rig.run(1.0);
    rig.camera->want_still();
    rig.run(0.2);
    rig.camera->choose("b");
    rig.run(5.0);
    EXPECT_EQ(rig.given_up, 1U);
    EXPECT_TRUE(rig.stills.empty());
}

/// Mishaps of any kind in any order cause no misuse. Every requested still ends, and when all is
/// well again the preview comes back.
TEST(StreamCameraTest, AnyOrderOfMishaps) {
    constexpr double longest_still_s = 40.0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        const auto draw = [&](unsigned of) { return static_cast<int>(random() % of); };
        const auto chance = [&](unsigned of) { return draw(of) == 0; };
        FakeCamera camera = chance(2) ? testing::usb_camera("a") : testing::board_camera("a");
        camera.abilities.modes = {{PixelFormat::bgr, {64, 48}}};  // quick to convert
        camera.abilities.has_exposure_lock = !chance(3);
        camera.abilities.has_focus_lock = camera.abilities.has_focus_lock && !chance(3);
        camera.tells_loops = chance(2);
        camera.sharpens_s = 0.1 * draw(20);
        Rig rig({camera});
        std::size_t asked = 0;
        std::optional<double> asked_s;
        for (int event = 0; event < 20; ++event) {
            FakeCamera& fake = rig.fake();
            fake.is_plugged = !chance(4);
            fake.is_dead = chance(5);
            fake.is_garbled = chance(8);
            fake.refuses_open = chance(8);
            fake.refuses_start = chance(8);
            fake.clipped_stills = draw(3);
            if (!asked_s && chance(2)) {
                rig.camera->want_still();
                ++asked;
                asked_s = rig.port->now_s;
            }
            rig.run(0.05 * (1 + draw(100)));
            if (rig.stills.size() + rig.given_up == asked) asked_s.reset();
            EXPECT_LT(asked_s ? rig.port->now_s - *asked_s : 0.0, longest_still_s);
        }
        rig.fake() = camera;
        rig.run(longest_still_s);
        EXPECT_EQ(rig.condition, CameraCondition::ready) << seed;
        EXPECT_EQ(rig.stills.size() + rig.given_up, asked) << seed;
        EXPECT_EQ(rig.port->misuses, 0) << seed;
    }
}

}  // namespace
}  // namespace touchline
