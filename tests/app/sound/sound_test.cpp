// Tests the kiosk's sound as a whole: the real voice, with a test device and test headphones.
#include "app/sound/sound.h"

#include "tests/audio-cues/spectrum.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Asks for blocks as fast as it may, on its own thread, and keeps what it got.
class FastDevice final : public SoundDevice {
  public:
    struct Heard {
        std::mutex mutex;
        std::vector<StereoFrame> frames;
        std::atomic<bool> is_missing{false};
        std::atomic<bool> is_gone{false};
    };

    explicit FastDevice(std::shared_ptr<Heard> heard) : heard_(std::move(heard)) {}

    ~FastDevice() override { close(); }

    Result<void> open(FrameSource source, int /*block*/) override {
        if (heard_->is_missing) return failure("There is no sound device.");
        thread_ = std::jthread([this, source = std::move(source)](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                std::array<StereoFrame, block_frames> block;
                source(block);
                {
                    const std::lock_guard lock(heard_->mutex);
                    heard_->frames.insert(heard_->frames.end(), block.begin(), block.end());
                }
                std::this_thread::sleep_for(std::chrono::microseconds(500));
            }
        });
        return {};
    }

    void close() override {
        thread_.request_stop();
        if (thread_.joinable()) thread_.join();
    }

    [[nodiscard]] bool is_gone() const override { return heard_->is_gone; }

  private:
    std::shared_ptr<Heard> heard_;
    std::jthread thread_;
};

class FakeHeadphones final : public HeadphonePresence {
  public:
    explicit FakeHeadphones(std::shared_ptr<std::atomic<int>> state) : state_(std::move(state)) {}

    [[nodiscard]] std::optional<bool> are_in(double) override {
        const int state = *state_;
        return state < 0 ? std::nullopt : std::optional(state == 1);
    }

  private:
    std::shared_ptr<std::atomic<int>> state_;  // -1: unknown
};

const std::string long_text =
    "This is a long text that goes on and on, so that there is time to stop it or to hold it.";

class SoundTest : public testing::Test {
  protected:
    SoundTest() {
        SoundParts parts;
        parts.world = {std::make_unique<FastDevice>(heard_),
                       std::make_unique<FakeHeadphones>(headphones_), nullptr};
        parts.languages.push_back(Language::load(TOUCHLINE_CATALOGUES, "de").value());
        parts.speak_program = TOUCHLINE_SPEAK;
        sound_ = std::make_unique<Sound>(std::move(parts), [this] { return next_event(); });
    }

    std::optional<ContactEvent> next_event() {
        const std::lock_guard lock(event_mutex_);
        return std::exchange(event_, std::nullopt);
    }

    void touch() {
        ContactEvent event;
        event.kind = ContactEventKind::contact_made;
        const std::lock_guard lock(event_mutex_);
        event_ = event;
    }

    /// Steps until `is_so`; if that never happens, the test program times out.
    template <class Condition>
    void step_until(Condition is_so) {
        while (!is_so()) {
            sound_->step(moment_);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    void say(const std::string& text, SpeechPriority priority = SpeechPriority::text) {
        sound_->say({"en", text, priority});
    }

    void wait_for_device() {
        step_until([&] { return has_heard_frames() && sound_->problem().empty(); });
    }

    [[nodiscard]] bool has_heard_frames() const {
        const std::lock_guard lock(heard_->mutex);
        return !heard_->frames.empty();
    }

    [[nodiscard]] bool is_heard() const {
        const std::lock_guard lock(heard_->mutex);
        return std::any_of(heard_->frames.begin(), heard_->frames.end(),
                           [](const StereoFrame& frame) { return frame.left != 0.0F; });
    }

    /// Returns true if the last tenth of a second was quiet.
    [[nodiscard]] bool is_quiet() const {
        const std::lock_guard lock(heard_->mutex);
        const auto& frames = heard_->frames;
        return frames.size() > 4800 &&
               std::all_of(frames.end() - 4800, frames.end(), [](const StereoFrame& frame) {
                   return frame.left == 0.0F && frame.right == 0.0F;
               });
    }

    void forget_heard() {
        const std::lock_guard lock(heard_->mutex);
        heard_->frames.clear();
    }

    [[nodiscard]] const std::deque<SpeechRecord>& transcript() const {
        return sound_->speaker().queue().transcript();
    }

    [[nodiscard]] bool was_said(const std::string& text) const {
        return std::any_of(transcript().begin(), transcript().end(),
                           [&text](const SpeechRecord& record) { return record.text == text; });
    }

    [[nodiscard]] bool is_being_said(const std::string& text) const {
        const auto& current = sound_->speaker().queue().current();
        return current && current->text == text;
    }

    void wait_for_said(const std::string& text) {
        step_until([&] { return was_said(text); });
    }

    std::shared_ptr<FastDevice::Heard> heard_ = std::make_shared<FastDevice::Heard>();
    std::shared_ptr<std::atomic<int>> headphones_ = std::make_shared<std::atomic<int>>(-1);
    std::mutex event_mutex_;
    std::optional<ContactEvent> event_;
    HandMoment moment_;
    std::unique_ptr<Sound> sound_;
};

TEST_F(SoundTest, AContactIsHeardAndTold) {
    wait_for_device();
    forget_heard();
    touch();
    step_until([&] { return is_heard(); });
    step_until([&] { return sound_->last_event().has_value(); });
    EXPECT_EQ(sound_->last_event()->kind, ContactEventKind::contact_made);
}

TEST_F(SoundTest, ATextIsSaidByTheRealVoice) {
    wait_for_device();
    say("A house.");
    wait_for_said("A house.");
    EXPECT_TRUE(is_heard());
    EXPECT_FALSE(transcript().back().was_interrupted);
}

TEST_F(SoundTest, SP4_AHushStopsSpeechButNoSafetyMessage) {
    say(long_text);
    step_until([&] { return is_being_said(long_text); });
    sound_->hush();
    EXPECT_FALSE(sound_->speaker().queue().current());
    EXPECT_TRUE(transcript().back().was_interrupted);
    say("Let go of the handle.", SpeechPriority::safety);
    sound_->hush();
    EXPECT_TRUE(is_being_said("Let go of the handle."));
}

TEST_F(SoundTest, SP5_APauseIsNoStop) {
    say(long_text);
    step_until([&] { return is_being_said(long_text); });
    sound_->toggle_pause();
    EXPECT_TRUE(sound_->speaker().queue().is_paused());
    EXPECT_TRUE(is_being_said(long_text));
    sound_->toggle_pause();
    EXPECT_FALSE(sound_->speaker().queue().is_paused());
}

TEST_F(SoundTest, SpeechThatIsOffLeavesSafetyMessages) {
    SoundWanted wanted;
    wanted.is_speech_on = false;
    sound_->choose(wanted);
    say("A house.");
    EXPECT_FALSE(sound_->speaker().queue().current());
    say("There is no force.", SpeechPriority::safety);
    wait_for_said("There is no force.");
}

TEST_F(SoundTest, VO5_HeadphonesChangeTheOutputAndItsVolumeBeginsAnew) {
    *headphones_ = 0;
    step_until([&] { return sound_->output().kind == OutputKind::speaker; });
    EXPECT_EQ(sound_->are_headphones_in(), std::optional(false));
    EXPECT_EQ(sound_->output().first_volume, default_volume(SoundSettings{}.speaker));
    *headphones_ = 1;
    step_until([&] { return sound_->output().kind == OutputKind::headset; });
    EXPECT_EQ(sound_->output().first_volume, default_volume(SoundSettings{}.headset));
}

TEST_F(SoundTest, VO5_AKeypadTellsOfItsSocketBeforeAllElse) {
    *headphones_ = 1;
    step_until([&] { return sound_->are_headphones_in() == std::optional(true); });
    sound_->tell_headphones(false);
    step_until([&] { return sound_->output().kind == OutputKind::speaker; });
}

TEST_F(SoundTest, ADeviceThatIsLostIsToldAndComesBackByItself) {
    wait_for_device();
    heard_->is_missing = true;
    heard_->is_gone = true;
    step_until([&] { return !sound_->problem().empty(); });
    EXPECT_EQ(sound_->problem(), "There is no sound. Please call the staff.");
    SoundWanted wanted;
    wanted.language = 1;
    sound_->choose(wanted);
    EXPECT_EQ(sound_->problem(), "Es kommt kein Ton. Bitte rufen Sie das Personal.");
    say("A house.");
    wait_for_said("A house.");  // everything else goes on
    heard_->is_gone = false;
    heard_->is_missing = false;
    step_until([&] { return sound_->problem().empty(); });
}

TEST_F(SoundTest, SP9_AKeyIsHeardAndADeadOneSoundsElse) {
    wait_for_device();
    forget_heard();
    sound_->give(ScreenEvent::key_taken);
    step_until([&] { return is_heard(); });
    forget_heard();
    sound_->give(ScreenEvent::key_refused);
    step_until([&] { return is_heard(); });
}

/// Pan goes so far that one ear is 20 dB softer, not silent.
TEST_F(SoundTest, ATestToneIsLouderOnItsSide) {
    wait_for_device();
    for (const bool is_left : {true, false}) {
        step_until([&] { return is_quiet(); });
        forget_heard();
        sound_->play_side(is_left);
        step_until([&] { return is_heard(); });
        step_until([&] { return is_quiet(); });
        const std::lock_guard lock(heard_->mutex);
        double left = 0.0;
        double right = 0.0;
        for (const StereoFrame& frame : heard_->frames) {
            left += static_cast<double>(frame.left * frame.left);
            right += static_cast<double>(frame.right * frame.right);
        }
        EXPECT_GT(is_left ? left : right, 30.0 * (is_left ? right : left));
    }
}

TEST_F(SoundTest, NothingThatWasSaidIsKeptAfterAVisit) {
    say("A house.");
    wait_for_said("A house.");
    sound_->forget();
    EXPECT_TRUE(transcript().empty());
    EXPECT_FALSE(sound_->speaker().queue().current());
}

}  // namespace
}  // namespace touchline
