#include "audio-cues/speech/speech_queue.h"

#include <gtest/gtest.h>

namespace touchline {
namespace {

Utterance text(const std::string& words, SpeechPriority priority = SpeechPriority::text) {
    return {"en", words, priority};
}

TEST(SpeechQueue, NewTextCutsOlderTextAndHintsThatWait) {
    SpeechQueue queue;
    SpeechOrder order = queue.say(text("one"), 1.0);
    EXPECT_FALSE(order.stop);
    ASSERT_TRUE(order.begin);
    EXPECT_EQ(order.begin->text, "one");
    EXPECT_FALSE(queue.say(text("hint", SpeechPriority::hint), 1.5).begin);
    order = queue.say(text("two"), 2.0);
    EXPECT_TRUE(order.stop);
    ASSERT_TRUE(order.begin);
    EXPECT_EQ(order.begin->text, "two");
    EXPECT_FALSE(queue.finished(3.0).begin) << "the hint went with what it belonged to";
    ASSERT_EQ(queue.transcript().size(), 2U);
    EXPECT_TRUE(queue.transcript()[0].was_interrupted);
    EXPECT_FALSE(queue.transcript()[1].was_interrupted);
    EXPECT_EQ(queue.transcript()[1].begin_s, 2.0);
}

TEST(SpeechQueue, AHintWaitsForItsTurn) {
    SpeechQueue queue;
    (void)queue.say(text("one"), 1.0);
    (void)queue.say(text("first", SpeechPriority::hint), 1.1);
    (void)queue.say(text("second", SpeechPriority::hint), 1.2);
    EXPECT_EQ(queue.finished(2.0).begin->text, "first");
    EXPECT_EQ(queue.finished(3.0).begin->text, "second");
    EXPECT_FALSE(queue.finished(4.0).begin);
    EXPECT_FALSE(queue.current());
}

TEST(SpeechQueue, SafetyIsHeardToItsEnd) {
    SpeechQueue queue;
    (void)queue.say(text("one"), 1.0);
    SpeechOrder order = queue.say(text("danger", SpeechPriority::safety), 1.1);
    EXPECT_TRUE(order.stop);
    EXPECT_EQ(order.begin->text, "danger");
    order = queue.say(text("key"), 1.2);
    EXPECT_FALSE(order.stop);
    EXPECT_FALSE(order.begin);
    order = queue.say(text("more danger", SpeechPriority::safety), 1.3);
    EXPECT_FALSE(order.stop);
    order = queue.stop(1.4);
    EXPECT_FALSE(order.stop);
    EXPECT_EQ(queue.finished(2.0).begin->text, "more danger");
    EXPECT_FALSE(queue.finished(3.0).begin) << "the key's text was forgotten by the stop";
}

TEST(SpeechQueue, SP4_AKeyStopsAndForgets) {
    SpeechQueue queue;
    (void)queue.say(text("one"), 1.0);
    (void)queue.say(text("hint", SpeechPriority::hint), 1.1);
    const SpeechOrder order = queue.stop(1.2);
    EXPECT_TRUE(order.stop);
    EXPECT_FALSE(order.begin);
    EXPECT_FALSE(queue.current());
    EXPECT_TRUE(queue.transcript().back().was_interrupted);
    EXPECT_FALSE(queue.stop(1.3).stop) << "nothing is being said";
}

TEST(SpeechQueue, RepeatsWhatWasSaidLast) {
    SpeechQueue queue;
    EXPECT_FALSE(queue.repeat(0.5).begin);
    (void)queue.say(text("one"), 1.0);
    SpeechOrder order = queue.repeat(1.5);
    EXPECT_TRUE(order.stop) << "from its beginning";
    EXPECT_EQ(order.begin->text, "one");
    (void)queue.finished(2.0);
    order = queue.repeat(2.5);
    EXPECT_FALSE(order.stop);
    EXPECT_EQ(order.begin->text, "one");
    queue.forget();
    EXPECT_FALSE(queue.repeat(3.0).begin);
    EXPECT_TRUE(queue.transcript().empty());
}

TEST(SpeechQueue, APauseIsOfWhatIsBeingSaidAndEndsWithIt) {
    SpeechQueue queue;
    EXPECT_FALSE(queue.toggle_pause()) << "nothing to pause";
    (void)queue.say(text("one"), 1.0);
    EXPECT_TRUE(queue.toggle_pause());
    EXPECT_FALSE(queue.toggle_pause());
    EXPECT_TRUE(queue.toggle_pause());
    (void)queue.say(text("two"), 2.0);
    EXPECT_FALSE(queue.is_paused());
}

/// Recordings of parts may last much longer than a hand stays on them.
TEST(SpeechQueue, WhatTheHandIsOnTakesThePlaceOfWhatItWasOn) {
    SpeechQueue queue;
    const auto part = [](const std::string& name, SpeechPriority priority) {
        Utterance utterance = text(name, priority);
        utterance.is_of_hand = true;
        return utterance;
    };
    (void)queue.say(text("screen"), 1.0);
    (void)queue.say(part("roof", SpeechPriority::hint), 1.1);
    (void)queue.say(text("other hint", SpeechPriority::hint), 1.2);
    SpeechOrder order = queue.say(part("wall", SpeechPriority::hint), 1.3);
    EXPECT_FALSE(order.stop) << "the screen is said to its end";
    EXPECT_EQ(queue.finished(2.0).begin->text, "other hint") << "the hand has left the roof";
    EXPECT_EQ(queue.finished(3.0).begin->text, "wall");
    order = queue.say(part("door", SpeechPriority::hint), 3.1);
    EXPECT_TRUE(order.stop);
    EXPECT_EQ(order.begin->text, "door");
    EXPECT_TRUE(queue.transcript().back().was_interrupted);
    (void)queue.say(text("danger", SpeechPriority::safety), 3.2);
    EXPECT_FALSE(queue.say(part("roof", SpeechPriority::hint), 3.3).stop);
}

TEST(SpeechQueue, SaysARecordingAgain) {
    SpeechQueue queue;
    Utterance utterance = text("A boat. 3 outlines.");
    utterance.recorded = {{0, 6, std::make_shared<const VoiceRecording>()}};
    (void)queue.say(utterance, 1.0);
    EXPECT_EQ(queue.current()->recorded, utterance.recorded);
    (void)queue.finished(2.0);
    EXPECT_EQ(queue.repeat(3.0).begin->recorded, utterance.recorded);
}

TEST(SpeechQueue, NeverGrowsWithoutEnd) {
    SpeechQueue queue;
    for (int i = 0; i < 1000; ++i) {
        (void)queue.say(text("text"), i);
        for (int k = 0; k < 100; ++k) (void)queue.say(text("hint", SpeechPriority::hint), i);
    }
    EXPECT_EQ(queue.transcript().size(), 200U);
    int said = 0;
    while (queue.finished(2000.0).begin) ++said;
    EXPECT_EQ(said, 32);
}

}  // namespace
}  // namespace touchline
