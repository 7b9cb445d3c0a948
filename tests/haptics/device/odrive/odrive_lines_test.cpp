// The lines of the maker's protocol, and what is made of lines that are not of it.
#include "haptics/device/odrive/odrive_lines.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string text_of(const OdriveText& text) {
    return {text.bytes().begin(), text.bytes().end()};
}

TEST(OdriveLines, EachCommandIsALineWithItsChecksum) {
    OdriveText text;
    text.end_line();
    text.torque(0, -0.0625);
    text.feed(1);
    text.ask_place(0);
    text.ask(1, "error");
    text.set(0, "config.watchdog_timeout", 0.02);
    text.set(1, "requested_state", 8);
    text.set_mark(41);
    text.ask_mark();
    text.clear_errors();
    EXPECT_EQ(text_of(text),
              "\n"
              "c 0 -0.062500*97\n"
              "u 1*100\n"
              "f 0*118\n"
              "r axis1.error*54\n"
              "w axis0.config.watchdog_timeout 0.020000*115\n"
              "w axis1.requested_state 8*11\n"
              "w test_property 41*60\n"
              "r test_property*28\n"
              "sc*16\n");
}

TEST(OdriveLines, TheChecksumIsThatOfTheMakersExample) {
    // "r vbus_voltage *93", where the space before the star counts.
    unsigned sum = 0;
    for (const char c : std::string("r vbus_voltage ")) sum ^= static_cast<unsigned char>(c);
    EXPECT_EQ(sum, 93U);
}

TEST(OdriveLines, ATorqueThatIsNotFiniteIsZero) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        OdriveText text, zero;
        text.torque(1, bad);
        zero.torque(1, 0.0);
        EXPECT_EQ(text_of(text), text_of(zero));
    }
}

std::string with_checksum(const std::string& text) {
    unsigned sum = 0;
    for (const char c : text) sum ^= static_cast<unsigned char>(c);
    return text + "*" + std::to_string(sum);
}

TEST(OdriveLines, AnswersAreReadByTheirKind) {
    const auto answer = [](const std::string& text) { return odrive_answer(with_checksum(text)); };
    EXPECT_EQ(answer("-0.250000 0.125000").kind, OdriveAnswer::Kind::place);
    EXPECT_EQ(answer("-0.250000 0.125000").value, -0.25);
    EXPECT_EQ(answer("0.020000").kind, OdriveAnswer::Kind::number);
    EXPECT_EQ(answer("2048").value, 2048.0);
    EXPECT_EQ(answer("invalid property").kind, OdriveAnswer::Kind::refused);
    EXPECT_EQ(answer("nan 0.0").kind, OdriveAnswer::Kind::refused);
    EXPECT_EQ(answer("1.0 nan").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(answer("1.0 2.0 3.0").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(answer("1.0x").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(answer("").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(odrive_answer("0.02").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(odrive_answer("0.02*0").kind, OdriveAnswer::Kind::wrong);
    EXPECT_EQ(odrive_answer("0.02*").kind, OdriveAnswer::Kind::wrong);
}

TEST(OdriveLines, OneFlippedBitOfAnAnswerIsNoticed) {
    const std::string line = with_checksum("-0.123456 0.654321");
    for (std::size_t i = 0; i < line.size(); ++i) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            std::string spoilt = line;
            spoilt[i] = static_cast<char>(spoilt[i] ^ static_cast<char>(1U << bit));
            EXPECT_NE(odrive_answer(spoilt).kind, OdriveAnswer::Kind::place) << spoilt;
        }
    }
}

RC_GTEST_PROP(OdriveLines, AnyLineIsReadWithoutHarm, (const std::string& line)) {
    RC_ASSERT(std::isfinite(odrive_answer(line).value));
    RC_ASSERT(std::isfinite(odrive_answer(with_checksum(line)).value));
}

}  // namespace
}  // namespace touchline
