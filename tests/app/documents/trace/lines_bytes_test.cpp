// Tests found lines as they pass between two workers.
#include "app/documents/trace/traced.h"

#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

/// A ring, a stroke and some of everything else.
Found lines_of_a_picture() {
    cv::Mat picture(300, 400, CV_8UC3, cv::Scalar::all(240));
    cv::circle(picture, {150, 150}, 90, {40, 90, 200}, cv::FILLED);
    cv::line(picture, {20, 280}, {390, 250}, cv::Scalar::all(10), 3);
    return find_lines(picture, {}).value();
}

/// The same map and the same report show that no part of the lines was lost.
TEST(LinesBytes, GiveTheSameMapAtEveryDetailAndZoom) {
    const Found before = lines_of_a_picture();
    const auto after = found_of(bytes_of(before));
    ASSERT_TRUE(after.has_value()) << after.error().line;
    ASSERT_EQ(after->lines.chains.size(), before.lines.chains.size());
    EXPECT_EQ(after->decision.reason, before.decision.reason);
    EXPECT_EQ(after->report.noise, before.report.noise);
    EXPECT_EQ(after->report.specks_dropped, before.report.specks_dropped);
    for (int detail = 1; detail <= 5; ++detail) {
        for (const double factor : {1.0, 2.5}) {
            const TraceOptions options{Area{}, detail, {{0.005, 0.01}, factor}};
            const auto first = trace_lines(before, options);
            const auto second = trace_lines(*after, options);
            ASSERT_EQ(first.has_value(), second.has_value());
            if (!first) continue;
            ASSERT_EQ(first->map.outlines.size(), second->map.outlines.size());
            for (std::size_t i = 0; i < first->map.outlines.size(); ++i)
                EXPECT_EQ(first->map.outlines[i].points, second->map.outlines[i].points);
            EXPECT_EQ(first->report.warning, second->report.warning);
            EXPECT_EQ(first->report.simplified.words, second->report.simplified.words);
        }
    }
}

TEST(LinesBytes, CutShortOrLongerAreRefused) {
    Found few = lines_of_a_picture();
    few.lines.chains.resize(std::min<std::size_t>(few.lines.chains.size(), 3));
    const Bytes whole = bytes_of(few);
    for (std::size_t size = 0; size < whole.size(); ++size)
        ASSERT_FALSE(found_of(std::span(whole).first(size)).has_value()) << size;
    Bytes longer = whole;
    longer.push_back({});
    EXPECT_FALSE(found_of(longer).has_value());
}

TEST(LinesBytes, WhatIsNotFiniteIsRefused) {
    Found found = lines_of_a_picture();
    found.lines.chains.back().points.back().at.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(found_of(bytes_of(found)).has_value());
    found = lines_of_a_picture();
    found.lines.high = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(found_of(bytes_of(found)).has_value());
}

RC_GTEST_PROP(LinesBytes, DamagedOnesAreLinesOrOneLine,
              (const std::vector<std::uint16_t>& places, std::uint8_t value)) {
    static const Bytes whole = bytes_of(lines_of_a_picture());
    Bytes bytes = whole;
    for (const std::uint16_t place : places)
        bytes[place % std::min<std::size_t>(bytes.size(), 512)] = std::byte{value};
    const auto found = found_of(bytes);
    if (!found) RC_ASSERT(found.error().line.find('\n') == std::string::npos);
}

}  // namespace
}  // namespace touchline
