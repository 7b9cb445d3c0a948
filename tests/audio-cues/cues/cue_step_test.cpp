#include "audio-cues/cues/cue_table.h"

#include <cmath>

#include <gtest/gtest.h>

namespace touchline {
namespace {

ContactEvent event(ContactEventKind kind, double time_s, double x_m = 0.0) {
    ContactEvent made;
    made.kind = kind;
    made.time_s = time_s;
    made.place_W = {x_m, 0.0};
    return made;
}

TEST(CueStep, EveryContactEventGivesTheCueOfItsRowAtItsPlaceAndTime) {
    for (std::size_t i = 0; i < contact_rows().size(); ++i) {
        const auto kind = static_cast<ContactEventKind>(i);
        if (kind == ContactEventKind::level_changed) continue;
        const CueStep step = cue_step(CueState{}, event(kind, 3.5, 0.029));
        ASSERT_TRUE(step.cue) << contact_rows()[i].event;
        EXPECT_EQ(step.cue->cue, contact_rows()[i].cue);
        EXPECT_EQ(step.cue->time_s, 3.5);
        EXPECT_NEAR(step.cue->pan, 0.5, 1e-12);
        EXPECT_FALSE(step.cue->is_alert);
    }
}

TEST(CueStep, ALevelIsFinerOrCoarserThanTheLast) {
    CueState state;
    state.level = 3.0;
    ContactEvent change = event(ContactEventKind::level_changed, 1.0);
    change.level = 2.0;
    CueStep step = cue_step(state, change);
    ASSERT_TRUE(step.cue);
    EXPECT_EQ(step.cue->cue, Cue::finer);
    change.level = 4.0;
    change.time_s = 2.0;
    step = cue_step(step.state, change);
    ASSERT_TRUE(step.cue);
    EXPECT_EQ(step.cue->cue, Cue::coarser);
    change.time_s = 3.0;
    EXPECT_FALSE(cue_step(step.state, change).cue) << "no change";
    change.level = std::nan("");
    EXPECT_FALSE(cue_step(step.state, change).cue);
}

TEST(CueStep, AHandThatTremblesOnALineDoesNotDrill) {
    CueState state;
    int touches = 0;
    for (int tick = 0; tick < 1000; ++tick) {
        const auto kind =
            tick % 2 == 0 ? ContactEventKind::contact_made : ContactEventKind::contact_lost;
        const CueStep step = cue_step(state, event(kind, 0.001 * tick));
        state = step.state;
        if (step.cue && step.cue->cue == Cue::touch) ++touches;
    }
    EXPECT_EQ(touches, 20);  // 50 ms apart
}

TEST(CueStep, OneCueDoesNotSilenceAnother) {
    CueStep step = cue_step(CueState{}, event(ContactEventKind::contact_made, 1.0));
    step = cue_step(step.state, event(ContactEventKind::vertex_passed, 1.001));
    ASSERT_TRUE(step.cue);
    EXPECT_EQ(step.cue->cue, Cue::corner);
}

TEST(CueStep, AClockThatBeganAnewSilencesNothing) {
    CueStep step = cue_step(CueState{}, event(ContactEventKind::contact_made, 1000.0));
    step = cue_step(step.state, event(ContactEventKind::contact_made, 0.5));
    EXPECT_TRUE(step.cue);
}

TEST(CueStep, NoneLeavesAlertsOnly) {
    CueState state;
    state.amount = CueAmount::none;
    for (std::size_t i = 0; i < contact_rows().size(); ++i) {
        ContactEvent made = event(static_cast<ContactEventKind>(i), 1.0);
        made.level = 1.0;
        EXPECT_FALSE(cue_step(state, made).cue);
    }
    EXPECT_FALSE(cue_step(state, ScreenEvent::key_taken, 1.0).cue);
    const CueStep fault = cue_step(state, ScreenEvent::fault, 1.0);
    ASSERT_TRUE(fault.cue);
    EXPECT_TRUE(fault.cue->is_alert);
}

TEST(CueStep, EveryKeyIsHeardHoweverQuick) {
    CueStep step = cue_step(CueState{}, ScreenEvent::key_taken, 1.0);
    step = cue_step(step.state, ScreenEvent::key_taken, 1.01);
    ASSERT_TRUE(step.cue);
    EXPECT_EQ(step.cue->cue, Cue::key);
    EXPECT_EQ(step.cue->pan, 0.0);
}

TEST(CueStep, AnEventThatIsNoneGivesNothing) {
    EXPECT_FALSE(cue_step(CueState{}, event(static_cast<ContactEventKind>(200), 1.0)).cue);
    EXPECT_FALSE(cue_step(CueState{}, static_cast<ScreenEvent>(200), 1.0).cue);
}

}  // namespace
}  // namespace touchline
