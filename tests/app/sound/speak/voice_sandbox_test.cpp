// Tries what a text could do if it captured the voice: in the real program, with an engine that is
// loaded before its own.
#include "app/isolation/process/child.h"
#include "app/sound/speak/messages.h"
#include "app/sound/speak/speaker.h"
#include "tests/app/isolation/sandbox/acts.h"
#include "tests/app/sound/speak/captured_voice.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr ChildEnd worked{act_worked, 0};
constexpr ChildEnd was_refused{act_refused, 0};

/// Returns how a voice ends that the call filter kills.
ChildEnd killed_for(const Act& act) {
    return {0, deadly_signal(act)};
}

/// Returns how touchline-speak ends when its engine tries the act that the text names.
ChildEnd captured_by(std::string_view act) {
    std::array<int, 2> ends{-1, -1};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    const Descriptor ours(ends[0]);
    const Descriptor theirs(ends[1]);
    const std::array<const Descriptor*, 1> handed{&theirs};
    setenv("LD_PRELOAD", TOUCHLINE_CAPTURED_VOICE, 1);
    auto child = Child::start(TOUCHLINE_SPEAK, {"en"}, handed);
    unsetenv("LD_PRELOAD");
    if (!child) return {};
    SpeakOrder order;
    order.bytes = static_cast<std::uint32_t>(act.size());
    std::copy(act.begin(), act.end(), order.text.begin());
    EXPECT_EQ(send(ours.number(), &order, sizeof order, 0), static_cast<ssize_t>(sizeof order));
    return child->reap();
}

std::string whole(const fs::path& file) {
    std::string text;
    std::getline(std::ifstream(file), text, '\0');
    return text;
}

class VoiceSandbox : public testing::Test {
  protected:
    VoiceSandbox() {
        fs::create_directories(folder_);
        fs::current_path(folder_);  // the voice's too
        std::ofstream("victim") << "whole";
    }

    ~VoiceSandbox() override {
        fs::current_path(folder_.parent_path());
        fs::remove_all(folder_);
    }

    fs::path folder_ =
        fs::temp_directory_path() / ("touchline-voice-sandbox-" + std::to_string(getpid()));
};

TEST_F(VoiceSandbox, EveryActOfACapturedVoiceIsDenied) {
    ASSERT_GE(acts().size(), 39U);
    for (const Act& act : acts()) {
        const ChildEnd end = captured_by(act.name);
        EXPECT_TRUE(end == killed_for(act) || end == was_refused)
            << act.name << ": " << describe(end);
        EXPECT_EQ(whole("victim"), "whole") << act.name;
        EXPECT_FALSE(fs::exists("must-not-exist")) << act.name;
    }
}

/// Otherwise the test above would prove nothing: the captured engine is loaded, and what it may do
/// works.
TEST_F(VoiceSandbox, WhatACapturedVoiceMayDoIsSeen) {
    EXPECT_EQ(captured_by("nothing"), was_refused);
    EXPECT_EQ(captured_by("no such act"), (ChildEnd{act_unknown, 0}));
    EXPECT_NE(worked, was_refused);
}

TEST_F(VoiceSandbox, IsFilteredAndLimited) {
    VoiceProcess voice(TOUCHLINE_SPEAK);
    std::string minutes;
    for (int i = 0; i < 60; ++i) minutes += "The roof is above the door, and the door is red. ";
    voice.begin("en", minutes, EngineRate{280, 0});
    std::vector<float> samples;
    while (samples.size() < 10000) {
        voice.receive(0.0, samples);
        (void)poll(nullptr, 0, 1);
    }
    const fs::path process = "/proc/" + std::to_string(voice.pid());
    const std::string status = whole(process / "status");
    EXPECT_NE(status.find("NoNewPrivs:\t1"), std::string::npos);
    EXPECT_NE(status.find("Seccomp:\t2"), std::string::npos);
    const std::string limits = whole(process / "limits");
    EXPECT_NE(limits.find("Max file size             0                    0"), std::string::npos)
        << limits;
    EXPECT_NE(limits.find("Max address space         268435456            268435456"),
              std::string::npos);
}

TEST_F(VoiceSandbox, EndsWhenNobodyListens) {
    std::array<int, 2> ends{-1, -1};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    Descriptor ours(ends[0]);
    Descriptor theirs(ends[1]);
    const std::array<const Descriptor*, 1> handed{&theirs};
    auto child = Child::start(TOUCHLINE_SPEAK, {"en"}, handed);
    ASSERT_TRUE(child);
    EXPECT_TRUE(ours.close());
    EXPECT_TRUE(theirs.close());
    EXPECT_EQ(child->reap(), (ChildEnd{1, 0}));
}

}  // namespace
}  // namespace touchline
