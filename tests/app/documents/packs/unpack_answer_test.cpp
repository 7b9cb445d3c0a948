// Tests answers of touchline-unpack: only what the real program would write is believed.
#include "app/documents/packs/pack.h"
#include "app/documents/packs/unpack_work.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace touchline {
namespace {

UnpackAnswer answer() {
    return {3,
            {{FindingKind::lines_near, "a.svg", 7, "fin and tail", 2.5}},
            {{"a.svg", {std::byte{1}, std::byte{2}}}, {"b/c.txt", {}}}};
}

TEST(UnpackAnswer, WrittenAndReadIsTheSame) {
    const auto back = unpack_answer_of(bytes_of(answer()));
    ASSERT_TRUE(back.has_value());
    EXPECT_TRUE(*back == answer());
}

TEST(UnpackAnswer, CutOrGrownItIsNone) {
    const auto bytes = bytes_of(answer());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(unpack_answer_of(std::span(bytes).first(size)).has_value()) << size;
    auto longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(unpack_answer_of(longer).has_value());
}

TEST(UnpackAnswer, AnotherHeaderIsNone) {
    const auto bytes = bytes_of(answer());
    for (std::size_t at = 0; at < 10; ++at) {
        auto lie = bytes;
        lie[at] ^= std::byte{0x40};
        EXPECT_FALSE(unpack_answer_of(lie).has_value()) << at;
    }
}

void expect_disbelieved(const UnpackAnswer& lie, const char* what) {
    EXPECT_FALSE(unpack_answer_of(bytes_of(lie)).has_value()) << what;
}

TEST(UnpackAnswer, WhatTheWorkerMayNotSayIsNone) {
    auto lie = answer();
    lie.entries[1].name = "../c.txt";
    expect_disbelieved(lie, "a name that leads out");
    lie = answer();
    lie.entries[1].name = "A.SVG";
    expect_disbelieved(lie, "a name twice");
    lie = answer();
    lie.difficulty = 6;
    expect_disbelieved(lie, "a difficulty");
    lie = answer();
    lie.findings[0].value = std::numeric_limits<double>::quiet_NaN();
    expect_disbelieved(lie, "no number");
    lie = answer();
    lie.findings[0].line = -1;
    expect_disbelieved(lie, "a line");
    lie = answer();
    lie.findings[0].kind = static_cast<FindingKind>(finding_kind_count);
    expect_disbelieved(lie, "a kind");
    lie = answer();
    for (std::size_t i = 0; i < pack_limits.files; ++i)
        lie.entries.push_back({"f" + std::to_string(i), {}});
    expect_disbelieved(lie, "too many entries");
}

TEST(UnpackAnswer, TextsAreMadeFitBeforeTheyAreSent) {
    auto hostile = answer();
    hostile.findings[0].what = "\x1b[2J\xff\n" + std::string(5000, 'x');
    const auto back = unpack_answer_of(bytes_of(hostile));
    ASSERT_TRUE(back.has_value());
    EXPECT_LE(back->findings[0].what.size(), most_finding_text_bytes);
    EXPECT_EQ(back->findings[0].what.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace touchline
