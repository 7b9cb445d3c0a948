#include "config/types/fields.h"

#include <array>
#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

enum class Kind : std::uint8_t { first, last };

struct Record {
    double share = 0.5;
    std::int16_t count = 0;
    Kind kind = Kind::first;
    bool is_set = false;
    std::string name = {};

    friend bool operator==(const Record&, const Record&) = default;
};

template <class Fields, class Some>
void fields(Fields& f, Some& record) {
    f.number(record.share, 0.0, 1.0);
    f.number(record.count);
    f.choice(record.kind, Kind::last);
    f.flag(record.is_set);
    f.template text<std::uint8_t>(record.name);
}

std::vector<std::byte> bytes_of(const Record& record) {
    ByteWriter bytes;
    fields(bytes, record);
    return bytes.take();
}

bool is_sound(const Record& record) {
    FieldCheck check;
    fields(check, record);
    return check.is_sound();
}

RC_GTEST_PROP(Fields, ComeBackAsTheyWere, (std::int16_t count, bool is_set)) {
    const std::string name(*rc::gen::inRange<std::size_t>(0, 256), 'n');
    const Record record{0.25, count, Kind::last, is_set, name};
    const auto kept = bytes_of(record);
    ByteReader bytes(kept);
    Record back;
    fields(bytes, back);
    RC_ASSERT(bytes.is_at_end());
    RC_ASSERT(back == record);
}

TEST(Fields, WhatIsCutShortFailsAndGivesZerosFromThere) {
    const auto whole = bytes_of({0.25, 7, Kind::last, true, "name"});
    for (std::size_t size = 0; size < whole.size(); ++size) {
        ByteReader bytes(std::span{whole}.first(size));
        Record back;
        fields(bytes, back);
        EXPECT_FALSE(bytes.is_good()) << size;
        EXPECT_TRUE(back.name.empty());
        EXPECT_EQ(bytes.number<std::uint32_t>(), 0U);
    }
}

TEST(Fields, ChoicesAndFlagsThatThereAreNotFail) {
    const std::array raw{std::byte{2}, std::byte{2}};
    ByteReader choice(raw);
    Kind kind = Kind::last;
    choice.choice(kind, Kind::last);
    EXPECT_FALSE(choice.is_good());
    EXPECT_EQ(kind, Kind::first);
    ByteReader flag(raw);
    bool is_set = true;
    flag.flag(is_set);
    EXPECT_FALSE(flag.is_good());
    EXPECT_FALSE(is_set);
}

TEST(Fields, ATextLongerThanItsSizeCanSayIsCut) {
    ByteWriter bytes;
    bytes.text<std::uint8_t>(std::string(300, 'x'));
    EXPECT_EQ(bytes.bytes().size(), 256U);
}

TEST(Fields, ACheckFailsOutsideTheRangeAndForNoNumber) {
    EXPECT_TRUE(is_sound({}));
    for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(is_sound({.share = bad})) << bad;
    EXPECT_FALSE(is_sound({.kind = static_cast<Kind>(2)}));
    Record odd;
    const std::uint8_t three = 3;
    std::memcpy(&odd.is_set, &three, 1);
    FieldCheck check;
    fields(check, odd);
    EXPECT_FALSE(check.is_sound());
    FieldCheck finite;
    finite.finite(std::numeric_limits<float>::infinity());
    EXPECT_FALSE(finite.is_sound());
}

struct Flat {
    Kind kind = Kind::first;
    double share = 0.5;
    std::int16_t count = 0;
    bool is_set = false;
};

TEST(Fields, AMemberThatIsNotNamedShowsAtTheEnd) {
    const Flat flat;
    FieldEnd whole;
    whole.choice(flat.kind, Kind::last);
    whole.number(flat.share, 0.0, 1.0);
    whole.number(flat.count);
    whole.flag(flat.is_set);
    EXPECT_EQ(whole.bytes(), sizeof(Flat));
    FieldEnd without_share;
    without_share.choice(flat.kind, Kind::last);
    without_share.number(flat.count);
    without_share.flag(flat.is_set);
    EXPECT_NE(without_share.bytes(), sizeof(Flat));
}

}  // namespace
}  // namespace touchline
