// The conversation with the emulated service, on a virtual clock.
#include "tests/machines/sim/inverse3/emulated_service.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::shared_ptr<const IntendedPath> still() {
    return std::make_shared<WaypointPath>(
        std::vector<WaypointPath::Waypoint>{{0.0, {0.01, -0.02}}});
}

struct Talk {
    explicit Talk(ServiceTruth truth = {}, std::string_view name = {})
        : service(std::move(truth), still()), link(service, now_s, name) {}

    void rest(double span_s) {
        for (double left_s = span_s; left_s > 0.0; left_s -= 0.001) link.rest(0.001);
    }

    /// One tick a millisecond in which this force is wanted.
    void push(Space force_N, double span_s) {
        for (double left_s = span_s; left_s > 5e-4; left_s -= 0.001) {
            link.rest(0.001);
            link.tell({force_N, ++number});
        }
    }

    double now_s = 0.0;
    ServiceEmulator service;
    EmulatedService link;
    std::uint64_t number = 0;
};

std::string line_of(const Talk& talk) {
    const auto ready = talk.link.session().readiness();
    return ready ? "" : ready.error().line;
}

TEST(Inverse3Session, TheOnlyDeviceIsChosenAndEachForceIsAnsweredWithAPlace) {
    Talk talk;
    EXPECT_NE(line_of(talk), "");
    talk.rest(0.4);
    EXPECT_EQ(line_of(talk), "");
    talk.push({0.5, 0.0, -0.25}, 0.1);
    const ArmNews news = talk.link.news();
    EXPECT_GE(news.places, 98U);  // of 100 ticks, and the list's
    EXPECT_EQ(talk.service.applied_N(), (Space{0.5, 0.0, -0.25}));
    EXPECT_NEAR(news.place_m.x, talk.service.place_m().x, 1e-5);
    EXPECT_NEAR(news.place_m.z, talk.service.place_m().z, 1e-5);
    EXPECT_FALSE(news.applies_none);
    EXPECT_EQ(news.answered + 1, talk.number);
    EXPECT_EQ(news.no_news, 0U);
}

TEST(Inverse3Session, TheFirstForceGoes50msAfterTheListThatComesFirst) {
    Inverse3Session session("");
    const ServiceEmulator service({}, still());
    session.hear(service.greet(), 1.0);
    EXPECT_FALSE(session.due({{}, 1}, 1.049));
    EXPECT_TRUE(session.due({{}, 1}, 1.051));
}

TEST(Inverse3Session, AnOlderServiceIsToldInItsOwnWords) {
    ServiceTruth older;
    older.has_session = false;
    Talk talk(older);
    talk.rest(0.4);
    talk.push({0.0, 1.0, 0.0}, 0.01);
    EXPECT_EQ(talk.service.applied_N(), (Space{0.0, 1.0, 0.0}));
}

TEST(Inverse3Session, ADeviceThatIsPluggedInLaterIsFound) {
    ServiceTruth none;
    none.arms.clear();
    Talk talk(none);
    talk.rest(1.0);
    EXPECT_NE(line_of(talk).find("no Inverse3 is plugged in"), std::string::npos);
    EXPECT_LE(talk.link.sent(), 4U);  // a question each 0.2 s
    ServiceTruth one;
    Talk other(one);
    other.rest(0.4);
    EXPECT_EQ(line_of(other), "");
}

TEST(Inverse3Session, OfTwoDevicesTheNamedOneIsTakenOrNone) {
    ServiceTruth two;
    two.arms.push_back({"05DA"});
    Talk unnamed(two);
    unnamed.rest(0.5);
    EXPECT_NE(line_of(unnamed).find("more than one Inverse3 is plugged in (04EA, 05DA)"),
              std::string::npos);
    EXPECT_EQ(unnamed.service.told_forces().size(), 0U);
    Talk named(two, "04EA");
    named.rest(0.5);
    EXPECT_EQ(line_of(named), "");
    Talk absent(two, "0000");
    absent.rest(0.5);
    EXPECT_NE(line_of(absent).find("Inverse3 0000 is not plugged in"), std::string::npos);
}

TEST(Inverse3Session, ASmallerKindIsRefused) {
    ServiceTruth small;
    small.arms[0].type = "minverse";
    Talk unnamed(small), named(small, "04EA");
    unnamed.rest(0.5);
    named.rest(0.5);
    EXPECT_NE(line_of(unnamed).find("no Inverse3"), std::string::npos);
    EXPECT_NE(line_of(named).find("is no Inverse3"), std::string::npos);
}

TEST(Inverse3Session, WhatHindersIsOneLineAndGoesWhenItIsOver) {
    Talk talk;
    talk.rest(0.4);
    const auto seen = [&](bool ArmTruth::*condition) {
        talk.service.arm().*condition = !(talk.service.arm().*condition);
        talk.push({}, 0.005);
        const Hindrance hindrance = talk.link.news().hindrance;
        const std::string line = line_of(talk);
        EXPECT_EQ(line, words_of(hindrance));
        EXPECT_EQ(line.find('\n'), std::string::npos);
        talk.service.arm().*condition = !(talk.service.arm().*condition);
        talk.push({}, 0.005);
        EXPECT_EQ(line_of(talk), "");
        return hindrance;
    };
    EXPECT_EQ(seen(&ArmTruth::has_power), Hindrance::no_power);
    EXPECT_EQ(seen(&ArmTruth::is_calibrated), Hindrance::not_calibrated);
    EXPECT_EQ(seen(&ArmTruth::is_ready), Hindrance::not_ready);
    EXPECT_EQ(seen(&ArmTruth::has_workspace_scaled), Hindrance::other_axes);
}

TEST(Inverse3Session, AMountThatOnlyTheListTellsOfHindersForGood) {
    ServiceTruth turned;
    turned.arms[0].is_mount_turned = true;
    Talk talk(turned);
    talk.rest(0.4);
    talk.push({}, 0.1);
    EXPECT_EQ(talk.link.news().hindrance, Hindrance::other_axes);
}

TEST(Inverse3Session, AForceThatNobodyRenewsBecomesZeroWithin25ms) {
    Talk talk;
    talk.rest(0.4);
    talk.push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_EQ(talk.service.applied_N().x, 1.0);
    talk.rest(0.025);
    EXPECT_EQ(talk.service.applied_N(), Space{});
    EXPECT_TRUE(talk.link.news().applies_none);
    talk.rest(1.0);  // and the service goes on being heard
    const std::uint64_t places = talk.link.news().places;
    talk.rest(0.1);
    EXPECT_GT(talk.link.news().places, places);
}

TEST(Inverse3Session, AServiceThatDoesNotAnswerIsToldZeroOnceWithin25ms) {
    ServiceTruth truth;
    truth.idle_after_s = 1e9;  // the worst that a service could do
    Talk talk(truth);
    talk.rest(0.4);
    talk.push({1.0, 0.0, 0.0}, 0.05);
    talk.link.spoil(AnswerFault::late, 1000, 0.5);
    talk.push({1.0, 0.0, 0.0}, 0.025);
    EXPECT_EQ(talk.service.applied_N(), Space{});
    const std::size_t sent = talk.link.sent();
    talk.push({1.0, 0.0, 0.0}, 0.3);
    EXPECT_EQ(talk.link.sent(), sent);
    EXPECT_EQ(talk.service.applied_N(), Space{});
}

TEST(Inverse3Session, LateAnswersCountOnlyOnceTheNewestIsIn) {
    Talk talk;
    talk.rest(0.4);
    talk.push({1.0, 0.0, 0.0}, 0.05);
    const std::uint64_t places = talk.link.news().places;
    talk.link.spoil(AnswerFault::late, 2, 0.05);  // to the force, and to the zero 18 ms later
    talk.push({1.0, 0.0, 0.0}, 0.065);
    EXPECT_EQ(talk.link.news().places, places) << "the first tells of 50 ms ago";
    talk.push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_GT(talk.link.news().places, places + 30);
    EXPECT_EQ(talk.service.applied_N().x, 1.0);
}

TEST(Inverse3Session, WhatCannotBeReadOrWasNotAskedForIsCountedAndTellsNoPlace) {
    for (const AnswerFault fault :
         {AnswerFault::cut, AnswerFault::garbled, AnswerFault::other_arm}) {
        Talk talk;
        talk.rest(0.4);
        talk.push({}, 0.01);
        const ArmNews before = talk.link.news();
        talk.link.spoil(fault, 10);
        talk.push({}, 0.009);
        EXPECT_LE(talk.link.news().places, before.places + 1);
        EXPECT_GE(talk.link.news().no_news, before.no_news + 8);
        talk.push({}, 0.01);
        EXPECT_GT(talk.link.news().places, before.places + 5);
    }
    Talk talk;
    talk.rest(0.4);
    talk.link.spoil(AnswerFault::doubled, 5);
    talk.push({}, 0.02);
    EXPECT_EQ(talk.link.news().no_news, 5U);
}

TEST(Inverse3Session, AnAnswerThatNeverComesIsSilenceForGood) {
    Talk talk;
    talk.rest(0.4);
    talk.push({1.0, 0.0, 0.0}, 0.05);
    talk.link.spoil(AnswerFault::lost);
    talk.push({1.0, 0.0, 0.0}, 0.005);
    const std::uint64_t places = talk.link.news().places;
    talk.push({1.0, 0.0, 0.0}, 1.0);
    EXPECT_EQ(talk.link.news().places, places);
    EXPECT_EQ(talk.service.applied_N(), Space{});
}

TEST(Inverse3Session, TheEndOfTheConversationIsTold) {
    Talk talk;
    talk.rest(0.4);
    talk.push({1.0, 0.0, 0.0}, 0.05);
    EXPECT_FALSE(talk.link.news().is_gone);
    talk.link.close();
    EXPECT_TRUE(talk.link.news().is_gone);
    EXPECT_EQ(talk.service.applied_N(), Space{});
}

}  // namespace
}  // namespace touchline
