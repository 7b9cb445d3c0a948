#include "app/sound/speak/speaker.h"
#include "audio-cues/speech/espeak_engine.h"
#include "config/types/steady_clock.h"
#include "tests/app/signal_one.h"

#include <csignal>
#include <cstdio>

#include <gtest/gtest.h>
#include <poll.h>

namespace touchline {
namespace {

constexpr EngineRate slow{80, 8};
constexpr EngineRate quick{280, 0};

const std::string& long_text() {
    static const std::string text = [] {
        std::string all;
        for (int i = 0; i < 25; ++i)
            all += "The roof is above the door, and the door is in the wall. ";
        return all;
    }();
    return text;
}

/// Receives until `count` samples are there or no more come. The clock stands still, so nothing is
/// too slow.
void receive(VoiceProcess& voice, std::vector<float>& samples, std::size_t count) {
    while (!voice.is_done() && samples.size() < count) {
        voice.receive(0.0, samples);
        (void)poll(nullptr, 0, 1);
    }
}

std::vector<float> all_of(VoiceProcess& voice) {
    std::vector<float> samples;
    receive(voice, samples, static_cast<std::size_t>(-1));
    return samples;
}

/// The samples of an undisturbed process.
std::vector<float> expected(const std::string& voice, const std::string& text,
                            const EngineRate& rate) {
    VoiceProcess fresh(TOUCHLINE_SPEAK);
    fresh.begin(voice, text, rate);
    return all_of(fresh);
}

/// Returns the length of what the engine says in this process; its state differs, so only the
/// length compares.
std::size_t expected_length(const std::string& voice, const std::string& text,
                            const EngineRate& rate) {
    auto engine = EspeakEngine::start(voice);
    EXPECT_TRUE(engine);
    std::size_t count = 0;
    engine->speak(text, rate, [&count](std::span<const std::int16_t> piece) {
        count += piece.size();
        return true;
    });
    return count * 48000 / 22050;
}

TEST(VoiceProcess, SaysWhatTheEngineSaysInSeveralLanguages) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    for (const auto& [name, text] :
         {std::pair("en", "Touched a line."), std::pair("de", "Die Linie."),
          std::pair("de", "Das Display zeigt: Download."), std::pair("fr-fr", "La ligne."),
          std::pair("fr-fr", "Le week-end."), std::pair("es", "La línea.")}) {
        voice.begin(name, text, slow);
        const auto heard = all_of(voice);
        EXPECT_GT(heard.size(), 20000U);
        EXPECT_NEAR(static_cast<double>(heard.size()),
                    static_cast<double>(expected_length(name, text, slow)), 2400.0);
        EXPECT_EQ(heard, expected(name, text, slow)) << name << ": " << text;
    }
    EXPECT_EQ(voice.restarts(), 0);
    EXPECT_EQ(voice.given_up(), 0);
}

TEST(VoiceProcess, KilledInMidSentenceItGoesOnWhereItWas) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", long_text(), quick);
    std::vector<float> samples;
    for (int deaths = 0; deaths < 2; ++deaths) {
        receive(voice, samples, samples.size() + 50000);
        ASSERT_FALSE(voice.is_done());
        signal_one(voice.pid(), SIGKILL);
        const std::int64_t killed_ns = steady_now_ns();
        const int before = voice.restarts();
        while (voice.restarts() == before) voice.receive(0.0, samples);
        receive(voice, samples, samples.size() + 1);
        // Reported, not judged: the machine may be busy. 1 s of speech waits in the mixer
        // meanwhile.
        std::printf("back after %.1f ms\n",
                    static_cast<double>(steady_now_ns() - killed_ns) * 1e-6);
    }
    receive(voice, samples, static_cast<std::size_t>(-1));
    EXPECT_EQ(voice.restarts(), 2);
    EXPECT_EQ(voice.given_up(), 0);
    EXPECT_EQ(samples, expected("en", long_text(), quick)) << "not a sample lost or said twice";
}

TEST(VoiceProcess, NothingOfWhatWasStoppedComesAfterwards) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", long_text(), quick);
    std::vector<float> samples;
    receive(voice, samples, 10000);
    voice.stop();
    EXPECT_TRUE(voice.is_done());
    samples.clear();
    voice.receive(0.0, samples);
    EXPECT_TRUE(samples.empty());
    voice.begin("en", "Touched a line.", slow);
    EXPECT_EQ(all_of(voice), expected("en", "Touched a line.", slow));
    EXPECT_EQ(voice.restarts(), 0);
}

TEST(VoiceProcess, ANewTextReplacesTheOldOneWithoutAStop) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", long_text(), quick);
    std::vector<float> samples;
    receive(voice, samples, 10000);
    voice.begin("en", "Left the line.", slow);
    EXPECT_EQ(all_of(voice), expected("en", "Left the line.", slow));
}

TEST(VoiceProcess, DiedWhileIdleItIsStartedForTheNextText) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", "One.", slow);
    std::vector<float> samples = all_of(voice);
    voice.receive(0.0, samples);  // started in advance
    ASSERT_GT(voice.pid(), 0);
    signal_one(voice.pid(), SIGKILL);
    voice.begin("en", "Two.", slow);
    EXPECT_EQ(all_of(voice), expected("en", "Two.", slow));
}

/// Kills the waiting process again and again; returns whether one waited before each kill.
std::vector<bool> waits_before_kills(VoiceProcess& voice, int kills, double now_s) {
    std::vector<float> samples;
    std::vector<bool> waits;
    for (int i = 0; i < kills; ++i) {
        voice.receive(now_s, samples);
        waits.push_back(voice.pid() > 0);
        if (voice.pid() < 0) break;
        const pid_t dead = voice.pid();
        signal_one(dead, SIGKILL);
        while (voice.pid() == dead) voice.receive(now_s, samples);
    }
    return waits;
}

TEST(VoiceProcess, DiedWhileIdleAnotherOneWaits) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", "One.", slow);
    (void)all_of(voice);
    EXPECT_EQ(waits_before_kills(voice, 4, 0.0), (std::vector{true, true, true, false}));
    const double later_s = 1.1 * VoiceProcess::patience_s;
    EXPECT_EQ(waits_before_kills(voice, 2, later_s), (std::vector{true, false}));
    EXPECT_EQ(voice.restarts(), 0);
    voice.begin("en", "Two.", slow);
    EXPECT_EQ(all_of(voice), expected("en", "Two.", slow));
}

TEST(VoiceProcess, AfterATextThatWasStoppedAnotherOneWaits) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    std::vector<float> samples;
    voice.receive(0.0, samples);
    EXPECT_EQ(voice.pid(), -1) << "nothing was ever said";
    voice.begin("en", long_text(), quick);
    voice.receive(0.0, samples);
    voice.stop();
    EXPECT_EQ(waits_before_kills(voice, 2, 0.0), (std::vector{true, true}));
}

TEST(VoiceProcess, WhatAlwaysDiesIsGivenUpAfterThreeTimes) {
    for (const char* program : {"/bin/false", "/no/such/program"}) {
        VoiceProcess voice(program);
        voice.begin("en", "One.", slow);
        EXPECT_TRUE(all_of(voice).empty());
        EXPECT_TRUE(voice.is_done());
        EXPECT_EQ(voice.given_up(), 1);
        EXPECT_EQ(voice.restarts(), 3);
    }
}

TEST(VoiceProcess, AProcessThatIsSilentTooLongIsStartedAnew) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    voice.begin("en", long_text(), quick);
    std::vector<float> samples;
    receive(voice, samples, 10000);
    const pid_t first = voice.pid();
    signal_one(first, SIGSTOP);
    for (int i = 0; i < 100 && voice.pid() == first; ++i) voice.receive(0.1 * i, samples);
    EXPECT_EQ(voice.restarts(), 1);
    receive(voice, samples, static_cast<std::size_t>(-1));
    EXPECT_EQ(samples, expected("en", long_text(), quick));
}

}  // namespace
}  // namespace touchline
