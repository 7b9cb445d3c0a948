// Tests that anything but a map gives one clear line, and that no file makes the reader slow, large
// or wrong.
#include "app/documents/decode/map_svg.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace touchline {
namespace {

bool is_one_line(const std::string& line) {
    return !line.empty() && std::none_of(line.begin(), line.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
    });
}

void expect_refused(const std::string& text, const std::string& because) {
    const auto map = parse_map_svg(text);
    ASSERT_FALSE(map) << text.substr(0, 200);
    EXPECT_TRUE(is_one_line(map.error().line)) << map.error().line;
    EXPECT_NE(map.error().line.find(because), std::string::npos) << map.error().line;
}

std::string plain_svg(const std::string& content) {
    return "<svg viewBox='0 0 116 84'>" + content + "</svg>";
}

TEST(MalformedMap, EachIsRefusedWithItsReason) {
    expect_refused("", "is empty");
    expect_refused("x", "is no XML");
    expect_refused("<svg", "is no XML");
    expect_refused("<svg viewBox='0 0 1 1'><path d='M0 0", "is no XML");
    expect_refused("<html/>", "but no SVG");
    expect_refused("<svg><path d='M0 0L1 1'/></svg>", "has no viewBox");
    for (const auto* box : {"", "0 0 116", "0 0 0 84", "0 0 116 -84", "0 0 nan 84", "0 0 1e999 84",
                            "0 0 116 84 5", "a b c d", "0 0 116mm 84mm"}) {
        expect_refused(std::string("<svg viewBox='") + box + "'><path d='M0 0L1 1'/></svg>",
                       "is not four finite numbers");
    }
    expect_refused(plain_svg(""), "holds no outline");
    expect_refused(plain_svg("<path/>"), "holds no outline");
    expect_refused(plain_svg("<path d='M1 1'/>"), "holds no outline");
    expect_refused(plain_svg("<defs><path d='M1 1L2 2'/></defs>"), "holds no outline");
    expect_refused(plain_svg("<path id='tail&#10;fin' d='M1 1L2'/>"),
                   "the map's <path> tail fin cannot be used: at character");
    expect_refused(plain_svg("<path d='M1 1Lnan 2'/>"), "finite numbers");
    expect_refused(plain_svg("<path d='M1 1L1e999 2'/>"), "finite numbers");
    expect_refused(plain_svg("<path d='M1e308 1l1e308 1 1e308 1'/>"), "not finite");
    expect_refused(plain_svg("<g transform='turn(3)'/>"), "transform cannot be read");
    expect_refused(plain_svg("<g transform='scale(1e200)'><path d='M1e200 1L2 2'/></g>"),
                   "not finite");
    expect_refused(plain_svg("<path data-weight='0' d='M1 1L2 2'/>"), "data-weight");
    expect_refused(plain_svg("<path data-weight='nan' d='M1 1L2 2'/>"), "data-weight");
    for (const auto* detail : {"0", "6", "", "1.5", "-1", "12"}) {
        expect_refused(plain_svg(std::string("<path data-detail='") + detail + "' d='M1 1L2 2'/>"),
                       "data-detail");
    }
    expect_refused(plain_svg("<circle r='5%'/>"), "r is no finite length");
    expect_refused(plain_svg("<rect x='1in' width='3' height='3'/>"), "x is no finite length");
    expect_refused(plain_svg("<polygon points='1 2 3'/>"), "pairs of finite numbers");
    expect_refused(plain_svg("<text x='left'>here</text>"), "place is not finite");
}

TEST(MalformedMap, TooManyPointsAreRefused) {
    std::string d = "M0 0";
    for (std::size_t i = 0; i < max_map_points / 2; ++i) d += "h1h1";
    expect_refused(plain_svg("<path d='" + d + "'/>"), "more than 4000000");
    // A few bytes that mean many points are refused before the points are made.
    std::string curves = "M0 0";
    for (int i = 0; i < 1000; ++i) curves += "a9e8 9e8 0 1 1 1 1";
    expect_refused(plain_svg("<path d='" + curves + "'/>"), "more than 4000000");
}

TEST(MalformedMap, EntitiesAreNeverExpanded) {
    std::string bomb = "<!DOCTYPE svg [<!ENTITY a \"aaaaaaaaaa\">";
    for (char name = 'b'; name < 'm'; ++name) {
        bomb += std::string("<!ENTITY ") + name + " \"";
        for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(name - 1) + ";";
        bomb += "\">";
    }
    bomb += "<!ENTITY file SYSTEM \"file:///etc/passwd\">]>" +
            plain_svg("<title>&l;&file;</title><path d='M1 1L2 2'/>");
    const auto map = parse_map_svg(bomb);
    ASSERT_TRUE(map) << map.error().line;
    EXPECT_EQ(map->title, "&l;&file;");
}

TEST(MalformedMap, DeepNestingIsRefusedAndManyEqualIdsAreQuick) {
    std::string open;
    for (int i = 0; i < 200000; ++i) open += "<g>";
    std::string close;
    for (int i = 0; i < 200000; ++i) close += "</g>";
    expect_refused(plain_svg(open + "<path d='M1 1L2 2'/>" + close), "deep");
    std::string words;
    for (int i = 0; i < 200000; ++i) words += "<tspan>";
    for (int i = 0; i < 200000; ++i) words += "</tspan>";
    EXPECT_TRUE(parse_map_svg(plain_svg("<text>" + words + "</text><path d='M1 1L2 2'/>")));

    std::string d;
    for (int i = 0; i < 100000; ++i) d += "M1 1L2 2";
    const auto map = parse_map_svg(plain_svg("<path id='same' d='" + d + "'/>"));
    ASSERT_TRUE(map);
    EXPECT_EQ(map->outlines.back().id, "same-100000");
}

/// Replaces, removes and doubles bytes of an SVG; seeded, so that a failure repeats.
TEST(MalformedMap, MutationsNeverCrashAndWhatIsReadIsWhole) {
    const std::string good = R"svg(<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg"
        viewBox="0 0 116 84"><title>T</title><g transform="rotate(30 4 4) scale(2)">
        <path id="a" data-label="A" data-weight="2" data-detail="3" d="M1 1C2 2 3 3 4 4S5 5 6 7Q1 2
        3 4T5 5A6 7 8 0 1 9 9H4V2h1v2z"/></g><circle cx="5" cy="5" r="4"/>
        <rect x="4" y="5" width="9" height="9" rx="2"/><polygon points="1,2 3,4 5,6"/>
        <text x="3" y="4">word</text></svg>)svg";
    constexpr std::string_view interesting = "0123456789.-+eE,<>/\"'&;= MLCZaz\n\0\xff";
    std::mt19937 random(7);
    int read = 0;
    for (int i = 0; i < 5000; ++i) {
        std::string text = good;
        for (unsigned k = 0; k <= random() % 4; ++k) {
            const std::size_t at = random() % text.size();
            const char byte = interesting[random() % interesting.size()];
            switch (random() % 4) {
                case 0:
                    text[at] = byte;
                    break;
                case 1:
                    text.insert(at, 1, byte);
                    break;
                case 2:
                    text.erase(at, 1 + random() % 9);
                    break;
                default:
                    text.insert(at, text.substr(at, random() % 30));
                    break;
            }
        }
        const auto map = parse_map_svg(text);
        if (!map) {
            ASSERT_TRUE(is_one_line(map.error().line)) << map.error().line;
            continue;
        }
        ++read;
        for (const Outline& outline : map->outlines) {
            ASSERT_GE(outline.points.size(), outline.is_closed ? 3U : 2U);
            ASSERT_TRUE(std::all_of(outline.points.begin(), outline.points.end(),
                                    [](Position p) { return is_finite(p); }));
            ASSERT_GT(outline.weight, 0.0);
            ASSERT_TRUE(outline.detail >= 1 && outline.detail <= 5);
        }
    }
    EXPECT_GT(read, 500);  // otherwise the mutations are too wild to reach anything
}

}  // namespace
}  // namespace touchline
