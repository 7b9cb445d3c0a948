// The kiosk's sound as a whole: the real voice, a device and headphones of our own.
#include "app/sound/sound.h"

#include "tests/audio-cues/spectrum.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>

#include <gtest/gtest.h>

namespace touchline {
namespace {

/// Asks for a block as fast as it is allowed to, on a thread of its own, and keeps what it got.
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

    Result<void> open(FrameSource source) override {
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

class SoundTest : public testing::Test {
  protected:
    SoundTest() {
        moment_.spoken.session = start_session(5).session;
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

    /// Steps until `is_so`; a test that waits in vain ends by the limit of its program.
    template <class Condition>
    void step_until(Condition is_so) {
        while (!is_so()) {
            sound_->step(moment_);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    void press(Key key) {
        const auto action = action_of(key);
        sound_->key_down(action ? std::optional(action->action) : std::nullopt);
        const Step step = press_key(moment_.spoken.session, key, 0.0);
        moment_.spoken.session = step.session;
        if (step.commands.sound) sound_->carry_out(*step.commands.sound);
    }

    [[nodiscard]] bool is_heard() const {
        const std::lock_guard lock(heard_->mutex);
        return std::any_of(heard_->frames.begin(), heard_->frames.end(),
                           [](const StereoFrame& frame) { return frame.left != 0.0F; });
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
    SoundMoment moment_;
    std::unique_ptr<Sound> sound_;
};

TEST_F(SoundTest, AContactIsHeardAndTold) {
    step_until([&] { return sound_->words().find("volume") != std::string::npos; });
    forget_heard();
    touch();
    step_until([&] { return is_heard(); });
    step_until([&] { return sound_->last_event().has_value(); });
    EXPECT_EQ(sound_->last_event()->kind, ContactEventKind::contact_made);
}

TEST_F(SoundTest, APictureIsNamedByTheRealVoice) {
    step_until([&] { return sound_->problem().empty() && sound_->words() != "starting"; });
    moment_.spoken.session =
        picture_ready(moment_.spoken.session, moment_.spoken.session.request, {"A house", 3, 4, ""})
            .session;
    wait_for_said("A house. 3 outlines.");
    EXPECT_TRUE(is_heard());
    EXPECT_FALSE(transcript().back().was_interrupted);
}

TEST_F(SoundTest, SP4_EveryKeyStopsSpeech) {
    sound_->step(moment_);
    press(Key{'H'});  // long
    step_until([&] { return sound_->speaker().queue().current().has_value(); });
    press(Key{'B'});
    sound_->step(moment_);
    EXPECT_FALSE(sound_->speaker().queue().current());
    EXPECT_TRUE(transcript().back().was_interrupted);
}

TEST_F(SoundTest, SP5_OneKeySaysItAgainAndOnePauses) {
    sound_->step(moment_);
    press(Key{'V'});
    press(Key{'V'});
    wait_for_said("Speech is on.");
    const auto count = transcript().size();
    press(Key{'A'});
    step_until([&] { return transcript().size() > count; });
    EXPECT_EQ(transcript().back().text, "Speech is on.");
    press(Key{'H'});
    step_until([&] { return sound_->speaker().queue().current().has_value(); });
    press(Key{'Z'});
    EXPECT_TRUE(sound_->speaker().queue().is_paused());
    EXPECT_TRUE(sound_->speaker().queue().current()) << "a pause is no stop";
    press(Key{'Z'});
    EXPECT_FALSE(sound_->speaker().queue().is_paused());
}

TEST_F(SoundTest, SpeechThatIsOffLeavesFaultsAndComesBack) {
    sound_->step(moment_);
    press(Key{'V'});
    wait_for_said("Speech is off.");
    press(Key{'M'});
    sound_->step(moment_);
    EXPECT_FALSE(sound_->speaker().queue().current());
    moment_.spoken.force.fault = Fault::too_fast;
    wait_for_said(spoken_fault(Fault::too_fast, Language()));
    press(Key{'V'});
    wait_for_said("Speech is on.");
}

TEST_F(SoundTest, TheLanguageIsThatOfSpeechToo) {
    sound_->step(moment_);
    press(Key{'N'});
    wait_for_said("Deutsch");
    EXPECT_EQ(transcript().back().language, "de");
    press(Key{'M'});
    wait_for_said("Art: Grat.");
}

TEST_F(SoundTest, VO5_HeadphonesInAndOutChangeTheOutputAndSayso) {
    *headphones_ = 0;
    wait_for_said("The headphones are out.");
    EXPECT_EQ(sound_->choice().output, OutputKind::speaker);
    press(Key{'H'});
    step_until([&] { return sound_->speaker().queue().current().has_value(); });
    press(Key{'='});
    *headphones_ = 1;
    wait_for_said("The headphones are in.");
    EXPECT_EQ(sound_->choice().output, OutputKind::headset);
    EXPECT_EQ(sound_->choice().volume, default_volume(SoundSettings{}.headset));
}

TEST_F(SoundTest, VO5_AKeyOfTheKeypadTellsOfItsSocketBeforeAllElse) {
    *headphones_ = 1;
    sound_->step(moment_);
    press(Key::f16);
    wait_for_said("The headphones are out.");
    EXPECT_EQ(sound_->choice().output, OutputKind::speaker);
    press(Key::f15);
    wait_for_said("The headphones are in.");
}

TEST_F(SoundTest, ADeviceThatIsLostIsToldAndComesBackByItself) {
    step_until([&] { return sound_->words().find("volume") != std::string::npos; });
    heard_->is_missing = true;
    heard_->is_gone = true;
    step_until([&] { return !sound_->problem().empty(); });
    EXPECT_EQ(sound_->problem(), "There is no sound. Please call the staff.");
    EXPECT_NE(sound_->words(), "");
    press(Key{'N'});
    wait_for_said("Deutsch");  // all else goes on
    EXPECT_EQ(sound_->problem(), "Es gibt keinen Ton. Bitte rufen Sie das Personal.");
    heard_->is_gone = false;
    heard_->is_missing = false;
    step_until([&] { return sound_->problem().empty(); });
    EXPECT_NE(sound_->words().find("volume 4 of 7, headset"), std::string::npos) << sound_->words();
}

TEST_F(SoundTest, SP9_EveryKeyIsHeardAndADeadOneSoundsElse) {
    step_until([&] { return sound_->words().find("volume") != std::string::npos; });
    forget_heard();
    sound_->key_down(Action::toggle_boxes);
    step_until([&] { return is_heard(); });
    forget_heard();
    sound_->key_down(std::nullopt);
    step_until([&] { return is_heard(); });
}

}  // namespace
}  // namespace touchline
