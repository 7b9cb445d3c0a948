#include "app/sound/speak/speaker.h"

#include "tests/app/signal_one.h"
#include "tests/audio-cues/spectrum.h"
#include "tests/audio-cues/wav_bytes.h"
#include "tests/config/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include <gtest/gtest.h>
#include <poll.h>

namespace touchline {
namespace {

class SpeakerTest : public testing::Test {
  protected:
    Speaker& start(RecordedPrompts prompts = {}) {
        speaker_ = std::make_unique<Speaker>(
            TOUCHLINE_SPEAK,
            std::map<std::string, SpokenLanguage>{
                {"en", {"en", 1.0}},
                {"de", {"de", 0.87, {{"kurz", "ein langer Satz nur für die Stimme"}}}}},
            std::move(prompts), mixer_);
        return *speaker_;
    }

    /// Steps the kiosk once: 16 ms of sound.
    std::vector<float> step() {
        speaker_->step(now_s_);
        now_s_ += 768.0 / frame_rate_Hz;
        const auto sound = left_of_stereo(rendered(mixer_, 768));
        all_.insert(all_.end(), sound.begin(), sound.end());
        return sound;
    }

    /// Steps until something sounds: the process needs its time, and the clock here stands still.
    void wait_for_sound() {
        while (peak(step()) == 0.0F) {
            now_s_ -= 768.0 / frame_rate_Hz;
            (void)poll(nullptr, 0, 1);
        }
    }

    /// Steps until all is said. This clock is faster than the process: it waits where nobody else
    /// would have to.
    void wait_for_end() {
        while (speaker_->queue().current()) {
            wait_for_voice();
            (void)step();
            now_s_ -= 768.0 / frame_rate_Hz;
        }
    }

    /// Waits until the voice has made the next step's sound, or has nothing more to say.
    void wait_for_voice() {
        while (!speaker_->voice().is_done() && mixer_.speech().waiting() < 768) {
            speaker_->step(now_s_);
            (void)poll(nullptr, 0, 1);
        }
    }

    static Utterance text(const std::string& words) { return {"en", words, SpeechPriority::text}; }

    Mixer mixer_;
    std::unique_ptr<Speaker> speaker_;
    std::vector<float> all_;
    double now_s_ = 0.0;
};

const std::string sentence =
    "The roof is above the door, and the door is in the middle of the wall.";

TEST_F(SpeakerTest, TheVoiceGetsItsOwnSpellingAndTheCaptionTheText) {
    Speaker& speaker = start();
    const auto samples_of = [&](const std::string& word) {
        all_.clear();
        speaker.say({"de", word, SpeechPriority::text}, now_s_);
        EXPECT_EQ(speaker.queue().current()->text, word);
        wait_for_end();
        return std::ranges::count_if(all_, [](float sample) { return sample != 0.0F; });
    };
    const auto respelled = samples_of("kurz");
    EXPECT_GT(respelled, 2 * samples_of("Kurz"));
    EXPECT_EQ(speaker.queue().transcript().front().text, "kurz");
}

TEST_F(SpeakerTest, SP4_AnyKeySilencesSpeechWithinFiftyMilliseconds) {
    Speaker& speaker = start();
    speaker.say(text(sentence), now_s_);
    wait_for_sound();
    for (int i = 0; i < 30; ++i) (void)step();
    speaker.stop(now_s_);
    std::vector<float> after;
    for (int i = 0; i < 20; ++i) {
        const auto sound = step();
        after.insert(after.end(), sound.begin(), sound.end());
    }
    EXPECT_EQ(rms(std::span(after).subspan(2400)), 0.0) << "50 ms";
    EXPECT_TRUE(speaker.queue().transcript().back().was_interrupted);
    EXPECT_FALSE(speaker.queue().current());
}

TEST_F(SpeakerTest, SP4_NewSpeechReplacesOldWithinFiftyMilliseconds) {
    Speaker& speaker = start();
    speaker.say(text(sentence + sentence + sentence), now_s_);
    wait_for_sound();
    speaker.say(text("Yes."), now_s_);
    wait_for_end();
    ASSERT_EQ(speaker.queue().transcript().size(), 2U);
    EXPECT_TRUE(speaker.queue().transcript()[0].was_interrupted);
    EXPECT_FALSE(speaker.queue().transcript()[1].was_interrupted);
    EXPECT_EQ(speaker.queue().transcript()[1].text, "Yes.");
}

TEST_F(SpeakerTest, AKilledVoiceIsNotHeard) {
    Speaker& speaker = start();
    std::string minutes;
    for (int i = 0; i < 50; ++i) minutes += sentence + " ";
    const auto ten_seconds = [&](bool is_killed) {
        speaker.say(text(minutes), now_s_);
        wait_for_sound();
        if (is_killed) signal_one(speaker.voice().pid(), SIGKILL);
        std::vector<float> sound;
        for (int i = 0; i < 625; ++i) {
            wait_for_voice();
            const auto part = step();
            now_s_ -= 768.0 / frame_rate_Hz;  // otherwise a busy machine's voice would count as
                                              // dead
            sound.insert(sound.end(), part.begin(), part.end());
        }
        speaker.stop(now_s_);
        for (int i = 0; i < 10; ++i) (void)step();
        // Compares from the first word on: on a busy machine it may come a part later.
        sound.erase(sound.begin(), std::find_if(sound.begin(), sound.end(),
                                                [](float value) { return value != 0.0F; }));
        sound.resize(400'000);
        return sound;
    };
    const auto whole = ten_seconds(false);
    EXPECT_EQ(speaker.voice().restarts(), 0);
    EXPECT_EQ(ten_seconds(true), whole) << "nothing lost, nothing twice";
    EXPECT_EQ(speaker.voice().restarts(), 1);
}

TEST_F(SpeakerTest, SP8_ARecordedPromptIsHeardInsteadOfTheVoice) {
    const ScratchFolder scratch;
    const std::string folder = scratch.path();
    std::filesystem::create_directory(folder + "/en");
    std::ofstream(folder + "/en/yes.wav") << wav_bytes(48000, 1, std::vector<int>(9600, 16384));
    std::ofstream(folder + "/en/index.txt") << "yes.wav\tYes.\n";
    std::vector<std::string> problems;
    Speaker& speaker = start(RecordedPrompts::read(folder, problems));
    std::filesystem::remove_all(folder);
    EXPECT_TRUE(problems.empty());
    speaker.say(text("Yes."), now_s_);
    wait_for_sound();
    wait_for_end();
    EXPECT_EQ(std::count_if(all_.begin(), all_.end(), [](float sample) { return sample != 0.0F; }),
              9600);
    EXPECT_EQ(speaker.voice().pid(), -1) << "no voice was needed";
    speaker.say(text("No."), now_s_);
    wait_for_sound();
    EXPECT_GT(speaker.voice().pid(), 0) << "nobody recorded this";
}

VoiceRecordingPtr tone(double long_s) {
    std::vector<std::int16_t> samples(static_cast<std::size_t>(long_s * frame_rate_Hz), 8192);
    return std::make_shared<const VoiceRecording>(VoiceRecording{std::move(samples), 2.0F});
}

Utterance boat(double title_s) {
    return {"en",
            "A boat. At sea. One outline.",
            SpeechPriority::text,
            {{0, 6, tone(title_s)}, {8, 15, tone(0.25)}}};
}

TEST_F(SpeakerTest, RecordingsAndTheVoiceTakeTurns) {
    Speaker& speaker = start();
    speaker.say(boat(0.5), now_s_);
    EXPECT_EQ(speaker.queue().current()->text, "A boat. At sea. One outline.");
    wait_for_sound();
    wait_for_end();
    const auto first = all_.begin() + static_cast<std::ptrdiff_t>(first_sound(all_));
    const auto level = 2.0F * of_full_scale(8192) / std::sqrt(2.0F);  // of one ear
    const auto run_of = [&](auto from, float value) {
        const auto is_other = [&](float sample) { return std::abs(sample - value) > 1e-3F; };
        return std::find_if(from, all_.end(), is_other);
    };
    const auto title_end = run_of(first, level);
    EXPECT_EQ(title_end - first, 24000) << "the title as long as it was recorded";
    const auto pause_end = run_of(title_end, 0.0F);
    EXPECT_EQ(pause_end - title_end, 12000) << "a short silence";
    const auto description_end = run_of(pause_end, level);
    EXPECT_EQ(description_end - pause_end, 12000) << "then the description";
    const std::vector<float> rest(description_end, all_.end());
    const std::size_t voice = first_sound(rest);
    EXPECT_GE(voice, 12000U);
    EXPECT_LT(voice, 24000U) << "nobody waits for the voice";
    EXPECT_GT(peak(rest), 0.05F) << "which says what nobody recorded";
    EXPECT_EQ(speaker.queue().transcript().size(), 1U);
}

TEST_F(SpeakerTest, AKeySilencesARecordingWithinFiftyMilliseconds) {
    Speaker& speaker = start();
    speaker.say(boat(10.0), now_s_);
    wait_for_sound();
    for (int i = 0; i < 30; ++i) EXPECT_GT(peak(step()), 0.1F);
    speaker.stop(now_s_);
    std::vector<float> after;
    for (int i = 0; i < 100; ++i) {
        const auto sound = step();
        after.insert(after.end(), sound.begin(), sound.end());
    }
    EXPECT_EQ(rms(std::span(after).subspan(2400)), 0.0) << "nor does anything after it sound";
    EXPECT_TRUE(speaker.queue().transcript().back().was_interrupted);
    EXPECT_TRUE(speaker.voice().is_done()) << "what it had ready is dropped";
}

TEST_F(SpeakerTest, TheRateIsTheVoicesAlone) {
    for (const std::size_t rate : {std::size_t{0}, speech_rates_per_minute.size() - 1}) {
        Speaker& speaker = start();
        all_.clear();
        speaker.set_rate(rate);
        speaker.say({"en", "A boat", SpeechPriority::text, {{0, 6, tone(0.5)}}}, now_s_);
        wait_for_end();
        EXPECT_EQ(std::ranges::count_if(all_, [](float sample) { return sample != 0.0F; }), 24000);
    }
}

TEST_F(SpeakerTest, PauseKeepsTheRestAndASecondPressGoesOn) {
    Speaker& speaker = start();
    speaker.say(text(sentence), now_s_);
    wait_for_sound();
    for (int i = 0; i < 10; ++i) (void)step();
    speaker.toggle_pause();
    (void)step();
    for (int i = 0; i < 50; ++i) EXPECT_EQ(peak(step()), 0.0F);
    EXPECT_TRUE(speaker.queue().current());
    speaker.toggle_pause();
    wait_for_sound();
    wait_for_end();
    EXPECT_FALSE(speaker.queue().transcript().back().was_interrupted);
}

TEST_F(SpeakerTest, AFasterRateIsShorter) {
    Speaker& speaker = start();
    std::vector<std::size_t> lengths;
    for (std::size_t rate = 0; rate < speech_rates_per_minute.size(); ++rate) {
        speaker.set_rate(rate);
        all_.clear();
        speaker.say(text(sentence), now_s_);
        wait_for_sound();
        const std::size_t before = all_.size();
        wait_for_end();
        lengths.push_back(all_.size() - before);
    }
    for (std::size_t i = 1; i < lengths.size(); ++i) EXPECT_LT(lengths[i], lengths[i - 1]);
    speaker.set_rate(99);
    EXPECT_EQ(speaker.rate(), 6U);
}

TEST_F(SpeakerTest, ForgetsWhatAVisitorHeard) {
    Speaker& speaker = start();
    speaker.say(text(sentence), now_s_);
    wait_for_sound();
    speaker.forget();
    EXPECT_FALSE(speaker.queue().current());
    EXPECT_TRUE(speaker.queue().transcript().empty());
    (void)step();
    (void)step();
    EXPECT_EQ(peak(step()), 0.0F);
}

}  // namespace
}  // namespace touchline
