// Tests names of files as they are said. The expected values are what a person reads aloud.
#include "app/documents/sticks/spoken_name.h"

#include "app/documents/sticks/names.h"
#include "config/types/utf8.h"
#include "tests/app/documents/sticks/any_names.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

Language loaded(const std::string& code) {
    const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
    EXPECT_TRUE(language) << (language ? "" : language.error().line);
    return language.value_or(Language());
}

struct Sample {
    std::string name, said;
};

void expect_all(const std::vector<Sample>& samples, const Language& language) {
    for (const Sample& sample : samples)
        EXPECT_EQ(spoken_name(sample.name, language), sample.said) << sample.name;
}

TEST(SpokenName, OfWordsIsThoseWords) {
    expect_all({{"boat.jpg", "boat"},
                {"garden-map.svg", "garden map"},
                {"Anna's dog_2.jpeg", "Anna's dog 2"},
                {"Haus12.png", "Haus 12"},
                {"\u00dcbersicht.pdf", "\u00dcbersicht"},
                {"K\u00e4se.png", "K\u00e4se"},
                {"\u732b.png", "\u732b"},
                {"xkcd.png", "x k c d"},
                {"USA.svg", "U S A"},
                {".png", "p n g"}},
               Language());
}

/// Old cards have such names: there capitals say nothing about a word.
TEST(SpokenName, OfCapitalsAloneIsWordsStill) {
    expect_all({{"THE CAT.JPG", "THE CAT"},
                {"THE CAT.jpg", "THE CAT"},
                {"\u00c4PFEL UND OBST.JPG", "\u00c4PFEL UND OBST"},
                {"DAD.JPG", "DAD"},
                {"DAD 2.JPG", "DAD 2"},
                {"XKCD.PNG", "X K C D"},
                {"IMG.JPG", "I M G"},
                {"MY IMG 4512.JPG", "MY I M G 45 12"},
                {"map of the USA.svg", "map of the U S A"},
                {"\u732b USA.svg", "\u732b U S A"},
                {"USA 2.svg", "U S A 2"},
                {"USA", "U S A"}},
               Language());
}

/// Said as people would name them, and no longer than needed.
TEST(SpokenName, OfACameraIsAPhoto) {
    expect_all({{"IMG_20240511_142233.jpg", "photo of 11th May 2024, 14:22"},
                {"DSC04512.JPG", "photo 45 12"},
                {"_MG_0007.CR2", "photo 7"},
                {"IMG_0000.jpg", "photo 0"},
                {"IMG_4512 (1).jpg", "photo 45 12, 1"},
                {"IMG_4512 dog.jpg", "photo 45 12 dog"},
                {"holiday-photo_final(2).png", "holiday photo final 2"},
                {"Scan 2024-05-11.pdf", "Scan, 11th May 2024"},
                {"IMG.jpg", "I M G"},
                {"IMG_dog.jpg", "I M G dog"},
                {"my IMG 4512.jpg", "my I M G 45 12"},
                {"SAM 5.jpg", "S A M 5"},
                {"Sam 2019.jpg", "Sam 2019"},
                {"img_4512.jpg", "photo 45 12"},
                {"dsc04512.jpg", "photo 45 12"},
                {"p1010085.jpg", "photo 101 00 85"},
                {"P12.jpg", "P 12"}},
               Language());
    const std::string name = "DSC04512.JPG";
    expect_all({{name, "Foto 45 12"}}, loaded("de"));
    expect_all({{name, "photo 45 12"}}, loaded("fr"));
    expect_all({{name, "foto 45 12"}}, loaded("es"));
    expect_all({{"Scan 2024-05-06.pdf", "Scan, vom sechsten Mai 2024"}}, loaded("de"));
}

TEST(SpokenName, ItsFormSaysHowMuchOfIt) {
    const auto said = [](NameDetail detail, int number = 0) {
        return spoken_name("IMG_20240511_142233.heic", Language(), {detail, number});
    };
    EXPECT_EQ(said(NameDetail::precise), "photo of 11th May 2024, 14:22 and 33 seconds");
    EXPECT_EQ(said(NameDetail::with_ending), "photo of 11th May 2024, 14:22, H E I C");
    EXPECT_EQ(said(NameDetail::whole), "I M G, 11th May 2024, 14:22 and 33 seconds, H E I C");
    EXPECT_EQ(said(NameDetail::plain, 2), "photo of 11th May 2024, 14:22, number 2");
}

TEST(SpokenName, OfHostileBytesIsHarmless) {
    expect_all({{"-rf", "r f"},
                {"%s%n.png", "s n"},
                {"a\nb.png", "a b"},
                {"\x1b[2Jgone.png", "2 Jgone"},
                {"\u202egnp.exe", "g n p"},
                {"\xff\xfe.png", "a file without a name"},
                {"<speak>[[x]]&amp;.svg", "speak x amp"},
                {"back\\slash.png", "back slash"},
                {"...", "a file without a name"},
                {"tab\there.png", "tab here"},
                {"zero\u200bwidth.png", "zero width"},
                {"a\u00a0b.png", "a b"},
                {"", "a file without a name"}},
               Language());
    std::string tower = "a";
    for (int i = 0; i < 50; ++i) tower += "\u0301";
    EXPECT_EQ(spoken_name(tower, Language()), "a\u0301\u0301\u0301");
}

TEST(SpokenName, OfNumbersIsInGroups) {
    expect_all({{"101085.jpg", "10 10 85"},
                {"IMG_2041.jpg", "photo 20 41"},
                {"DSC00123.JPG", "photo 123"},
                {"DSCN1234.JPG", "photo 12 34"},
                {"DSCF0042.RAF", "photo 42"},
                {"P1010085.JPG", "photo 101 00 85"},
                {"scan0007.tif", "scan 00 07"},
                {"Scan 3.pdf", "Scan 3"},
                {"007.png", "007"},
                {"12345678901.png", "123 45 67 89 01"},
                {"IMG-20230405-WA0012.jpg", "photo of 5th April 2023, W A 00 12"},
                {"100_0123.jpg", "100, 01 23"},
                {"2_123.png", "2, 123"},
                {"GOPR0123.JPG", "photo 123"},
                {"99999999.jpg", "99 99 99 99"},
                {"20231345.jpg", "20 23 13 45"},
                {"230405.png", "23 04 05"},
                {"\u0661\u0662\u0663\u0664.png", "12 34"}},
               Language());
}

TEST(SpokenName, AYearBesideAWordIsAYear) {
    expect_all({{"Holiday 2023.jpg", "Holiday 2023"},
                {"2019 summer.jpg", "2019 summer"},
                {"IMG_2019.jpg", "photo 20 19"},
                {"Berlin 1806.jpg", "Berlin 18 06"}},
               Language());
}

/// Cameras, telephones and systems write a moment in these ways.
TEST(SpokenName, ADateWithItsTimeIsReadAsOne) {
    const std::string moment = "5th April 2023, 10:15";
    for (const char* name : {"20230405_101500.jpg",
                             "20230405-101500.jpg",
                             "20230405101500.jpg",
                             "20230405T101500.jpg",
                             "20230405_101500123.jpg",
                             "20230405101500123.jpg",
                             "2023-04-05 10.15.00.jpg",
                             "2023-04-05_10-15-00.png",
                             "2023-04-05-10-15-00.png",
                             "2023-04-05 10:15.png",
                             "2023-04-05T10:15:00.png",
                             "2023-04-05 101500.png",
                             "2023-04-05 at 10.15.00.jpeg",
                             "2023-04-05 at 10.15.00 AM.png",
                             "2023-04-05 um 10.15.00.png",
                             "2023-04-05 \u00e0 10.15.00.png",
                             "2023-04-05 a\u0300 10.15.00.png",
                             "2023-04-05 a las 10.15.00.png",
                             "2023-04-05 alle 10.15.00.png",
                             "2023_04_05_10_15_00.jpg",
                             "2023-04-05 10h15.jpg",
                             "5.4.2023 10.15.png",
                             "05.04.2023 10-15-00.png",
                             "202304051015.png"})
        EXPECT_EQ(spoken_name(name, Language()), moment) << name;
    expect_all(
        {{"IMG_20230405_101500.jpg", "photo of " + moment},
         {"PXL_20230405_101500123.jpg", "photo of " + moment},
         {"IMG20230405101500.jpg", "photo of " + moment},
         {"WIN_20230405_10_15_00_Pro.jpg", "photo of " + moment + ", Pro"},
         {"WhatsApp Image 2023-04-05 at 10.15.00.jpeg", "WhatsApp Image, " + moment},
         {"WhatsApp Image 2023-04-05 at 10.15.00 (1).jpeg", "WhatsApp Image, " + moment + ", 1"},
         {"Screenshot_20230405-101500_Chrome.jpg", "Screenshot, " + moment + ", Chrome"},
         {"Screenshot from 2023-04-05 10-15-00.png", "Screenshot from, " + moment},
         {"Screen Shot 2023-04-05 at 3.07.09 PM.png", "Screen Shot, 5th April 2023, 15:07"},
         {"signal-2023-04-05-00-05-01.png", "signal, 5th April 2023, 0:05"}},
        Language());
}

TEST(SpokenName, ADateAloneIsOneToo) {
    expect_all({{"20230405.jpg", "5th April 2023"},
                {"2023-04-05.jpg", "5th April 2023"},
                {"Scan_20230405.pdf", "Scan, 5th April 2023"},
                {"05.04.2023.pdf", "5th April 2023"},
                {"25-12-2022.pdf", "25th December 2022"},
                {"12-25-2022.pdf", "25th December 2022"},
                {"25122022.pdf", "25th December 2022"},
                {"20240229.jpg", "29th February 2024"},
                {"2023-04-05 (2).jpg", "5th April 2023, 2"}},
               Language());
}

TEST(SpokenName, WhatNoCalendarHasIsNoDate) {
    expect_all({{"20230229.jpg", "20 23 02 29"},
                {"20230431.jpg", "20 23 04 31"},
                {"2023-13-05.jpg", "2023, 13, 05"},
                {"18990405.jpg", "18 99 04 05"},
                {"05-04-2023.jpg", "05, 04, 2023"},  // April or May
                {"2023-04-05 25.15.00.jpg", "5th April 2023, 25, 15, 00"},
                {"20230405_106100.jpg", "5th April 2023, 10 61 00"}},
               Language());
}

TEST(SpokenName, ADateIsOfTheVisitorsLanguage) {
    const std::string name = "IMG_20230401_101503.jpg";
    expect_all({{name, "Foto vom ersten April 2023, 10:15"}}, loaded("de"));
    expect_all({{name, "photo du 1er avril 2023, 10:15"}}, loaded("fr"));
    expect_all({{name, "foto del 1 de abril de 2023, 10:15"}}, loaded("es"));
    expect_all({{"", "eine Datei ohne Namen"}}, loaded("de"));
}

TEST(SpokenName, LongOnesAreCutBetweenWords) {
    EXPECT_EQ(spoken_name(std::string(200, 'w'), Language()), std::string(80, 'w'));
    EXPECT_EQ(spoken_name(std::string(70, 'a') + ' ' + std::string(70, 'b'), Language()),
              std::string(70, 'a'));
    EXPECT_EQ(spoken_name(std::string(200, '7'), Language()).size(), 80U);
}

/// Every day of two hundred years is a date, and nothing else is, by the calendar of the C++
/// library.
TEST(SpokenName, EveryDayOfTheCalendarIsOneAndNoOther) {
    using namespace std::chrono;
    const auto is_date = [](int year, unsigned month, unsigned day) {
        const auto parts = parts_of_name(fmt::format("{:04}{:02}{:02}", year, month, day), 80);
        const auto moment = moment_of(parts);
        return moment && moment->year == year && moment->month == static_cast<int>(month) &&
               moment->day == static_cast<int>(day);
    };
    for (int y = 1890; y < 2110; ++y)
        for (unsigned m = 0; m <= 13; ++m)
            for (unsigned d = 0; d <= 32; ++d) {
                const bool is_there =
                    y >= 1900 && y <= 2099 && year_month_day(year(y), month(m), day(d)).ok();
                ASSERT_EQ(is_date(y, m, d), is_there) << y << ' ' << m << ' ' << d;
            }
}

/// A moment in any form reads back as the same day and time.
RC_GTEST_PROP(SpokenName, AMomentInAnyFormIsItself, ()) {
    const int year = *rc::gen::inRange(1900, 2100);
    const int month = *rc::gen::inRange(1, 13);
    const int day = *rc::gen::inRange(1, 29);
    const int hour = *rc::gen::inRange(0, 24);
    const int minute = *rc::gen::inRange(0, 60);
    const int second = *rc::gen::inRange(0, 60);
    const auto sign = *rc::gen::elementOf(std::vector<std::string>{"", "-", "_", "."});
    const auto between = *rc::gen::elementOf(std::vector<std::string>{" ", "_", "-", " at ", "T"});
    const auto clock_sign = *rc::gen::elementOf(std::vector<std::string>{"", ".", "-", "_", ":"});
    const std::string name =
        fmt::format("{:04}{}{:02}{}{:02}{}{:02}{}{:02}{}{:02}", year, sign, month, sign, day,
                    between, hour, clock_sign, minute, clock_sign, second);
    const auto parts = parts_of_name(name, 80);
    const auto moment = moment_of(parts);
    RC_ASSERT(moment.has_value());
    RC_ASSERT(moment->parts == parts.size());
    RC_ASSERT(moment->year == year && moment->month == month && moment->day == day);
    RC_ASSERT(moment->clock.has_value());
    RC_ASSERT(moment->clock->hour == hour && moment->clock->minute == minute);
    RC_ASSERT(moment->clock->second == second);
}

/// All digits are said, in their order, and never more than three together except for a year.
RC_GTEST_PROP(SpokenName, NoNumberIsLongAndNoDigitIsLost, ()) {
    std::string digits;
    const int count = *rc::gen::inRange(1, 40);
    for (int i = 0; i < count; ++i) digits += static_cast<char>('0' + *rc::gen::inRange(0, 10));
    const auto parts = parts_of_name(digits, 80);
    RC_PRE(!moment_of(parts));
    const std::string said = spoken_name(digits, Language());
    std::string again;
    std::size_t run = 0;
    std::size_t longest = 0;
    for (const char c : said) {
        run = c == ' ' ? 0 : run + 1;
        longest = std::max(longest, run);
        if (c != ' ') again += c;
    }
    RC_ASSERT(again == digits);
    RC_ASSERT(longest <= 3 || digits.size() == 4);
}

RC_GTEST_PROP(SpokenName, IsWordsAndNothingElse, ()) {
    const std::string spoken = spoken_name(*any_name(), Language());
    RC_ASSERT(is_utf8(spoken));
    RC_ASSERT(!spoken.empty());
    RC_ASSERT(spoken.front() != ' ');
    RC_ASSERT(spoken.back() != ' ');
    RC_ASSERT(spoken.find("  ") == std::string::npos);
    const auto all = characters_of(spoken);
    RC_ASSERT(all.size() <= spoken_characters);
    for (const char32_t c : all)
        RC_ASSERT(has_mask(c, U_GC_L_MASK | U_GC_M_MASK | U_GC_N_MASK) || c == U' ' || c == U'\'' ||
                  c == U',' || c == U':');
}

}  // namespace
}  // namespace touchline
