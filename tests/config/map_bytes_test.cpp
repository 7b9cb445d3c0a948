#include "config/types/map_bytes.h"

#include "config/types/utf8.h"
#include "tests/config/map_samples.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

RC_GTEST_PROP(MapBytes, EveryMapComesBackBitForBit, ()) {
    const TactileMap map = random_map_sample(*rc::gen::arbitrary<std::uint32_t>());
    const auto bytes = bytes_of(map);
    RC_ASSERT(bytes.has_value());
    const auto back = map_of(*bytes);
    RC_ASSERT(back.has_value());
    RC_ASSERT(is_same_map(*back, map));
    RC_ASSERT(*bytes_of(*back) == *bytes);
}

TEST(MapBytes, EveryTruncationIsRefused) {
    const auto bytes = bytes_of(random_map_sample(7)).value();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        ASSERT_FALSE(map_of(std::span(bytes).first(size)).has_value()) << size;
    }
    auto longer = bytes;
    longer.push_back(std::byte{0});
    EXPECT_FALSE(map_of(longer).has_value());
}

TEST(MapBytes, HundredThousandDamagedMapsAreRefusedOrSound) {
    std::mt19937 random(20261122);
    int sound = 0;
    for (int round = 0; round < 100'000; ++round) {
        static constexpr unsigned samples = 50;
        auto bytes =
            bytes_of(random_map_sample(static_cast<std::uint32_t>(round) % samples)).value();
        const unsigned flips = 1 + draw(random, 3);
        for (unsigned i = 0; i < flips; ++i) {
            // Half of the changes hit the header, where a byte matters most.
            const std::size_t reach = draw(random, 2) == 0 ? std::size_t{32} : bytes.size();
            bytes[draw(random, static_cast<std::uint32_t>(reach))] ^=
                static_cast<std::byte>(1 + draw(random, 255));
        }
        const auto map = map_of(bytes);
        if (!map) {
            ASSERT_EQ(map.error().line.find('\n'), std::string::npos);
            continue;
        }
        ++sound;
        ASSERT_TRUE(is_sound(*map)) << round;
        ASSERT_TRUE(bytes_of(*map).has_value()) << round;
    }
    EXPECT_GT(sound, 1000);  // a map with a moved coordinate is still a map
}

TEST(MapBytes, MapsThatCannotBeAreNotWritten) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto refuses = [](auto&& damage) {
        TactileMap map = random_map_sample(3);
        damage(map);
        return !bytes_of(map).has_value();
    };
    ASSERT_FALSE(refuses([](TactileMap&) {}));
    for (const double bad : {nan, infinity, -infinity, 1.5, -1.5}) {
        EXPECT_TRUE(refuses([bad](TactileMap& map) { map.outlines[0].points[1].y = bad; })) << bad;
        EXPECT_TRUE(refuses([bad](TactileMap& map) { map.area.width_m = bad; })) << bad;
        EXPECT_TRUE(refuses([bad](TactileMap& map) { map.labels[0].place.x = bad; })) << bad;
    }
    for (const double bad : {nan, infinity, 0.0, -1.0}) {
        EXPECT_TRUE(refuses([bad](TactileMap& map) { map.outlines[0].weight = bad; })) << bad;
    }
    EXPECT_TRUE(refuses([](TactileMap& map) { map.outlines[0].points.resize(1); }));
    EXPECT_TRUE(refuses([](TactileMap& map) { map.outlines[0].detail = 0; }));
    EXPECT_TRUE(refuses([](TactileMap& map) { map.outlines[0].detail = 6; }));
    EXPECT_TRUE(refuses([](TactileMap& map) { map.outlines[1].id = map.outlines[0].id = "a"; }));
    EXPECT_TRUE(refuses([](TactileMap& map) { map.outlines.resize(MapLimits::outlines + 1); }));
    EXPECT_TRUE(
        refuses([](TactileMap& map) { map.outlines[0].points.resize(MapLimits::points + 1); }));
    EXPECT_TRUE(refuses([](TactileMap& map) { map.title.resize(MapLimits::text_bytes + 1); }));
}

TEST(MapBytes, MoreThanAMapMayHaveIsRefusedBeforeItIsKept) {
    constexpr std::size_t count_at = 48;  // of the outlines, where no text is before them
    constexpr std::size_t outline_bytes = 25;
    const auto empty = bytes_of(TactileMap{}).value();
    const auto why_refused = [&empty](std::uint32_t count) {
        auto bytes = empty;
        std::memcpy(&bytes[count_at], &count, sizeof count);
        bytes.resize(bytes.size() + count * outline_bytes);
        const auto map = map_of(bytes);
        return map ? std::string() : map.error().line;
    };
    EXPECT_NE(why_refused(MapLimits::outlines + 1).find("too many outlines"), std::string::npos);
    EXPECT_NE(why_refused(4'000'000).find("larger than a map may be"), std::string::npos);
    EXPECT_NE(why_refused(1).find("fewer than 2 points"), std::string::npos) << why_refused(1);
}

TEST(MapBytes, TextThatIsNoUtf8IsMarkedByTheWriterAndRefusedByTheReader) {
    TactileMap map = random_map_sample(3);
    map.title = "caf\xe9";
    auto bytes = bytes_of(map).value();
    EXPECT_EQ(map_of(bytes)->title, "caf?");
    const std::string text = "caf?";
    const auto at = std::search(bytes.begin(), bytes.end(), text.begin(), text.end(),
                                [](std::byte a, char b) { return static_cast<char>(a) == b; });
    ASSERT_NE(at, bytes.end());
    at[3] = std::byte{0xe9};
    EXPECT_FALSE(map_of(bytes).has_value());
}

TEST(Utf8, KnowsEveryCharacterAndNothingElse) {
    for (const char* const sound : {"", "a", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\x90\x9f",
                                    "\xed\x9f\xbf", "\xef\xbf\xbf", "\xf4\x8f\xbf\xbf"}) {
        EXPECT_TRUE(is_utf8(sound)) << sound;
        EXPECT_EQ(utf8_of(sound), sound);
    }
    for (const char* const damaged :
         {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
          "\xf0\x9f\x90", "\xff", "\xe2\x82z", "\xf8\x88\x80\x80\x80"}) {
        EXPECT_FALSE(is_utf8(damaged)) << damaged;
        EXPECT_TRUE(is_utf8(utf8_of(damaged)));
    }
    EXPECT_EQ(utf8_of("a\xffz\xe2\x82"), "a?z??");
    EXPECT_TRUE(is_utf8(std::string_view("\0", 1)));
}

}  // namespace
}  // namespace touchline
