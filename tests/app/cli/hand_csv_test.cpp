// Tests the hand's path in tables as spreadsheets and programs write them.
#include "app/cli/hand_csv.h"

#include <array>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::string error_of(std::string_view text, HandColumns wanted = HandColumns::place) {
    const auto rows = parse_hand_csv(text, wanted);
    return rows ? "no error" : rows.error().line;
}

/// Expects two steps of a hand, in any form.
void expect_two_steps(std::string_view text) {
    const auto rows = parse_hand_csv(text);
    ASSERT_TRUE(rows) << text << ": " << rows.error().line;
    ASSERT_EQ(rows->size(), 2U) << text;
    EXPECT_EQ((*rows)[0].p_WH, (Position{0.01, -0.02})) << text;
    EXPECT_EQ((*rows)[1].t_s, 0.001) << text;
    EXPECT_EQ((*rows)[1].p_WH, (Position{0.5, 0.25})) << text;
}

TEST(HandCsv, IsReadAsProgramsWriteIt) {
    for (const char* text :
         {"t_s,x_m,y_m\n0,0.01,-0.02\n0.001,0.5,0.25\n",
          "t_s,x_m,y_m\n0,0.01,-0.02\n0.001,0.5,0.25",
          "t_s,x_m,y_m\r\n0,0.01,-0.02\r\n0.001,0.5,0.25\r\n",
          "t_s,x_m,y_m\r0,0.01,-0.02\r0.001,0.5,0.25\r",
          "\xef\xbb\xbft_s,x_m,y_m\n0,0.01,-0.02\n0.001,0.5,0.25\n",
          "\"t_s\",\"x_m\",\"y_m\"\n\"0\",\"0.01\",\"-0.02\"\n\"0.001\",\"0.5\",\"0.25\"\n",
          " t_s , \"x_m\" ,y_m \n 0,+0.01 , -0.02\n\n 1e-3, 5e-1,.25 \n",
          "y_m,t_s,x_m\n-0.02,0,0.01\n0.25,0.001,0.5\n",
          "note,y_m,\"a, b\",t_s,x_m\n\"one\ntwo\",-0.02,,0,0.01\n\"\"\"x\"\"\",0.25,,0.001,0.5\n",
          "t_s,x_m,y_m,\n0,0.01,-0.02,\n0.001,0.5,0.25,,\n",
          "t_s,x_m,y_m,note\n0,0.01,-0.02\n0.001,0.5,0.25\n",
          "t_s;x_m;y_m\n0;0,01;-0,02\n0,001;0,5;0,25\n",
          "t_s;x_m;y_m\n0;0.01;-0.02\n0.001;0.5;0.25\n",
          "\"t_s\";\"x_m\";\"y_m\"\n\"0\";\"0,01\";\"-0,02\"\n\"0,001\";\"0,5\";\"0,25\"\n",
          "t_s\tx_m\ty_m\n0\t0,01\t-0,02\n0,001\t0,5\t0,25\n",
          "sep=;\r\nt_s;x_m;y_m\r\n0;0,01;-0,02\r\n0,001;0,5;0,25\r\n"})
        expect_two_steps(text);
}

TEST(HandCsv, AFaultIsOneLineWithTheLineOfTheText) {
    const std::string head = "t_s,x_m,y_m\n";
    EXPECT_EQ(error_of(""), "line 1: no column t_s; the first line must name t_s,x_m,y_m");
    EXPECT_EQ(error_of("\n\nt_s,y_m\n0,0\n"),
              "line 3: no column x_m; the first line must name t_s,x_m,y_m");
    EXPECT_EQ(error_of("0,0,0\n"), "line 1: no column t_s; the first line must name t_s,x_m,y_m");
    EXPECT_EQ(error_of("t_s,x_m,y_m,x_m\n0,0,0,0\n"), "line 1: two columns are called x_m");
    EXPECT_EQ(error_of("t_s,x_m,y_m\n0,0,0\n", HandColumns::place_and_angle),
              "line 1: no column angle_rad; the first line must name t_s,x_m,y_m,angle_rad");
    EXPECT_EQ(error_of(head), "no rows; each row is one step of the hand");
    EXPECT_EQ(error_of(head + "0,0\n"), "line 2: column y_m is missing");
    EXPECT_EQ(error_of(head + "0,0,\n"), "line 2: y_m is not a finite number");
    EXPECT_EQ(error_of(head + "0,0,0\n\n0.1,nan,0\n"), "line 4: x_m is not a finite number");
    EXPECT_EQ(error_of(head + "0,1e999,0\n"), "line 2: x_m is not a finite number");
    EXPECT_EQ(error_of(head + "0,0,0\n0,0,0\n"), "line 3: t_s does not increase");
    EXPECT_EQ(error_of(head + "0,12,0\n"),
              "line 2: more than 1 m from the centre; coordinates are metres");
    EXPECT_EQ(error_of(head + "0,\"0,0\n0.1,0,0\n"), "line 2: a quote is never closed");
    EXPECT_EQ(error_of(head + "0,0,0\n0.1,\"0\"1,0\n"),
              "line 3: something stands after a closing quote");
    EXPECT_EQ(error_of("note,t_s,x_m,y_m\n\"a\nb\",0,0,0\n\"c\",0,0,0\n"),
              "line 4: t_s does not increase");
}

/// Numbers with decimal commas between comma-separated values are reported, never misread.
TEST(HandCsv, ADecimalCommaIsReadRightlyOrRefused) {
    EXPECT_EQ(error_of("t_s,x_m,y_m\n0,0,01,-0,02\n"),
              "line 2: 5 values, but the first line names 3 columns; numbers need a decimal point");
    EXPECT_EQ(error_of("t_s,x_m,y_m\n\"0\",\"0,01\",\"0\"\n"),
              "line 2: x_m is not a finite number; write 0.01 for it");
    EXPECT_EQ(error_of("t_s;x_m;y_m\n0;1.234,5;0\n"), "line 2: x_m is not a finite number");
}

TEST(HandCsv, OtherEncodingsAreRefusedWithWhatToDo) {
    using namespace std::string_literals;
    EXPECT_EQ(error_of("\xff\xfet\0"s), "line 1: this is UTF-16; save it as CSV in UTF-8");
    EXPECT_EQ(error_of("t\0_\0"s), "line 1: this is UTF-16; save it as CSV in UTF-8");
    EXPECT_EQ(error_of("t_s,x_m,y_m\n0,0,0\n0.1,\0,0\n"s),
              "line 3: this is no text; save it as CSV in UTF-8");
}

/// Whatever is in the fields is read back, as RFC 4180 says.
RC_GTEST_PROP(CsvTable, WhatWasQuotedIsReadBack, ()) {
    const auto field =
        rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab \",;\t\r\n'\xc3")));
    const auto separator = *rc::gen::elementOf(std::string(",;\t"));
    const auto end = *rc::gen::elementOf(std::vector<std::string>{"\n", "\r\n", "\r"});
    const auto columns = *rc::gen::inRange<std::size_t>(2, 5);
    const auto rows = *rc::gen::container<std::vector<std::vector<std::string>>>(
        rc::gen::container<std::vector<std::string>>(columns, field));
    std::string text;
    for (std::size_t i = 0; i < columns; ++i)
        text += (i == 0 ? "" : std::string(1, separator)) + fmt::format("\"c{}\"", i);
    for (const auto& row : rows) {
        text += end;
        for (std::size_t i = 0; i < columns; ++i) {
            if (i > 0) text += separator;
            text += '"';
            for (const char c : row[i]) text += c == '"' ? "\"\"" : std::string(1, c);
            text += '"';
        }
    }
    const auto table = csv_table(text);
    RC_ASSERT(table.has_value());
    RC_ASSERT(table->separator == separator);
    std::vector<std::vector<std::string>> filled;
    for (const auto& row : rows)
        if (std::ranges::any_of(row, [](const auto& one) { return !one.empty(); }))
            filled.push_back(row);
    RC_ASSERT(table->rows.size() == filled.size() + 1);
    for (std::size_t i = 0; i < filled.size(); ++i)
        RC_ASSERT(table->rows[i + 1].fields == filled[i]);
}

/// Any bytes give rows or one line.
RC_GTEST_PROP(HandCsv, OfAnyBytesIsRowsOrOneLine, ()) {
    std::string text = "t_s,x_m,y_m\n0,0.01,-0.02\n0.001,\"0.5\",0.25\n0.002,0,0\n";
    const int changes = *rc::gen::inRange(1, 6);
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const int what = *rc::gen::inRange(0, 3);
        if (what == 0) text[at] = *rc::gen::elementOf(std::string("\",;\t\r\n0\0\xff", 9));
        if (what == 1) text.erase(at, *rc::gen::inRange<std::size_t>(1, 8));
        if (what == 2) text.insert(at, text.substr(at, 9));
    }
    const auto rows = parse_hand_csv(text);
    if (!rows) {
        RC_ASSERT(!rows.error().line.empty());
        RC_ASSERT(rows.error().line.find('\n') == std::string::npos);
        return;
    }
    for (const HandRow& row : *rows)
        RC_ASSERT(std::abs(row.p_WH.x) <= 1.0 && std::abs(row.p_WH.y) <= 1.0);
}

}  // namespace
}  // namespace touchline
