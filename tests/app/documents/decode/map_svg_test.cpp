#include "app/documents/decode/map_svg.h"

#include "app/documents/decode/files.h"
#include "tests/app/documents/decode/same_maps.h"

#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr ViewBox page{0.0, 0.0, 116.0, 84.0};

std::string svg(const std::string& content, const std::string& box = "0 0 116 84") {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + box + "\">" + content +
           "</svg>";
}

TactileMap parsed(const std::string& text) {
    auto map = parse_map_svg(text);
    EXPECT_TRUE(map) << map.error().line;
    return map.value_or(TactileMap{});
}

std::vector<Position> on_page(const std::vector<ViewBoxPoint>& points_mm) {
    std::vector<Position> points;
    for (const auto& p : points_mm) points.push_back(from_view_box(p.u_mm, p.v_mm, page));
    return points;
}

TEST(MapSvg, NamesWeightsAndDetailsAreRead) {
    const TactileMap map = parsed(svg(R"(
        <title> A  fish </title><desc>Seen from
        the side.</desc>
        <path id="body" data-label="Body" data-weight="2.5" data-detail="3" d="M10 10L20 10 20 20Z"/>
        <path d="M1 1L2 2"><title>Fin</title></path>
        <text data-label="1" x="5" y="6">A <tspan>word</tspan></text><text x="1 2">plain</text>
        <text x="3" y="3">  </text>)"));
    EXPECT_EQ(map.title, "A fish");
    EXPECT_EQ(map.description, "Seen from the side.");
    EXPECT_EQ(map.area, (Area{0.116, 0.084}));
    EXPECT_EQ(map.version, 0U);
    ASSERT_EQ(map.outlines.size(), 2U);
    EXPECT_EQ(map.outlines[0].id, "body");
    EXPECT_EQ(map.outlines[0].label, "Body");
    EXPECT_EQ(map.outlines[0].weight, 2.5);
    EXPECT_EQ(map.outlines[0].detail, 3);
    EXPECT_TRUE(map.outlines[0].is_closed);
    EXPECT_EQ(map.outlines[0].points, on_page({{10, 10}, {20, 10}, {20, 20}}));
    EXPECT_EQ(map.outlines[1].id, "");
    EXPECT_EQ(map.outlines[1].label, "Fin");
    EXPECT_EQ(map.outlines[1].weight, 1.0);
    EXPECT_EQ(map.outlines[1].detail, 1);
    EXPECT_FALSE(map.outlines[1].is_closed);
    ASSERT_EQ(map.labels.size(), 2U);
    EXPECT_EQ(map.labels[0].text, "A word");
    EXPECT_EQ(map.labels[0].place, from_view_box(5, 6, page));
    EXPECT_EQ(map.labels[1].place, from_view_box(1, 0, page));
}

TEST(MapSvg, TheViewBoxIsTheAreaWhereverItLies) {
    const TactileMap map = parsed(svg("<path d='M-10 5L10 45'/>", "-10, 5 20 40"));
    EXPECT_EQ(map.area, (Area{0.02, 0.04}));
    EXPECT_EQ(map.outlines[0].points, (std::vector<Position>{{-0.01, 0.02}, {0.01, -0.02}}));
}

TEST(MapSvg, BasicShapesAreOutlines) {
    const TactileMap map = parsed(svg(R"(
        <line x1="1" y1="2" x2="3" y2="4"/>
        <polyline points="1,2 3,4 5 0"/>
        <polygon points="1 2 3 4 5 0"/>
        <rect x="10" y="20px" width="30" height="40"/>
        <rect x="10" y="20" width="30" height="40" rx="5" ry="auto"/>
        <circle cx="50" cy="40" r="10"/>
        <ellipse cx="50" cy="40" rx="20" ry="10"/>
        <rect x="1" y="1" width="0" height="4"/><circle r="0"/><polyline points=""/>)"));
    ASSERT_EQ(map.outlines.size(), 7U);
    EXPECT_EQ(map.outlines[0].points, on_page({{1, 2}, {3, 4}}));
    EXPECT_EQ(map.outlines[1].points, on_page({{1, 2}, {3, 4}, {5, 0}}));
    EXPECT_FALSE(map.outlines[1].is_closed);
    EXPECT_EQ(map.outlines[2].points, on_page({{1, 2}, {3, 4}, {5, 0}}));
    EXPECT_TRUE(map.outlines[2].is_closed);
    EXPECT_EQ(map.outlines[3].points, on_page({{10, 20}, {40, 20}, {40, 60}, {10, 60}}));
    EXPECT_TRUE(map.outlines[3].is_closed);
    EXPECT_EQ(map.outlines[4].points.front(), from_view_box(15, 20, page));
    for (const Position p : map.outlines[4].points) {
        // Outside the rectangle without its corners, points lie only near the arcs' centres.
        const Position from_centre{std::abs(p.x + 0.033), std::abs(p.y - 0.002)};
        if (from_centre.x > 0.01 && from_centre.y > 0.015) {
            EXPECT_NEAR(norm(from_centre - Position{0.01, 0.015}), 0.005, 1e-8);
        }
    }
    for (const Position p : map.outlines[5].points) {
        EXPECT_NEAR(norm(p - from_view_box(50, 40, page)), 0.01, 1e-8);
    }
    for (const Position p : map.outlines[6].points) {
        const Position q = p - from_view_box(50, 40, page);
        EXPECT_NEAR(norm(Position{q.x / 2.0, q.y}), 0.01, 1e-8);
    }
    EXPECT_TRUE(map.outlines[5].is_closed && map.outlines[6].is_closed);
}

TEST(MapSvg, NestedTransformsActInsideOut) {
    const TactileMap map = parsed(svg(R"svg(
        <g transform="translate(10 20)"><a><g transform="scale(2)">
            <path transform="rotate(90)" d="M0 0L5 0"/><text x="1" y="1">t</text>
        </g></a></g>)svg"));
    EXPECT_EQ(map.outlines[0].points, on_page({{10, 20}, {10, 30}}));
    EXPECT_EQ(map.labels[0].place, from_view_box(12, 22, page));
}

TEST(MapSvg, WhatIsNotDrawnIsNotFelt) {
    const TactileMap map = parsed(svg(R"(
        <defs><path d="M0 0L1 1"/></defs><clipPath><circle r="4"/></clipPath>
        <symbol><path d="M0 0L1 1"/></symbol><mask><path d="M0 0L1 1"/></mask>
        <marker><path d="M0 0L1 1"/></marker><pattern><path d="M0 0L1 1"/></pattern>
        <g display="none"><path d="M0 0L1 1"/></g><path style="fill:red; display : none" d="M0 0L1 1"/>
        <!-- <path d="M0 0L1 1"/> --><image width="5" height="5"/><script>M0 0</script>
        <path id="seen" d="M0 0L1 1"/>)"));
    ASSERT_EQ(map.outlines.size(), 1U);
    EXPECT_EQ(map.outlines[0].id, "seen");
}

TEST(MapSvg, SubpathsAndRepeatedIdsBecomeUnique) {
    const TactileMap map = parsed(svg(R"(
        <path id="a" d="M0 0L1 1M2 2L3 3"/><path id="a-2" d="M0 0L1 1"/><path id="a" d="M5 5L6 6"/>
        <path d="M0 0L1 1"/><path d="M0 0L1 1"/>)"));
    std::vector<std::string> ids;
    for (const Outline& outline : map.outlines) ids.push_back(outline.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"a", "a-2", "a-2-2", "a-3", "", ""}));
}

TEST(MapSvg, PrefixedElementsAndCharacterDataAreRead) {
    const TactileMap map = parsed(
        "\xef\xbb\xbf<?xml version='1.0'?><!DOCTYPE svg><s:svg "
        "xmlns:s='http://www.w3.org/2000/svg' "
        "viewBox='0 0 116 84'><s:title><![CDATA[A & B]]></s:title><s:path d='M0 0L1 1'/></s:svg>");
    EXPECT_EQ(map.title, "A & B");
    EXPECT_EQ(map.outlines.size(), 1U);
}

TEST(MapSvg, ABrowserIsToldHowToDrawIt) {
    const std::string text = format_map_svg(
        {Area{}, {{on_page({{10, 20}, {30, 40.5}}), false, "x", "l\"&<", 1.5, 2}}, {}, "T", "", 7});
    EXPECT_EQ(text,
              "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"116mm\" height=\"84mm\" "
              "viewBox=\"0 0 116 84\">\n"
              "  <title>T</title>\n"
              "  <g fill=\"none\" stroke=\"black\" stroke-width=\"0.6\" stroke-linecap=\"round\" "
              "stroke-linejoin=\"round\">\n"
              "    <path id=\"x\" data-label=\"l&quot;&amp;&lt;\" data-weight=\"1.5\" "
              "data-detail=\"2\" d=\"M10 20 L30 40.5\" />\n"
              "  </g>\n"
              "</svg>\n");
}

TEST(MapSvg, AFileReadsBackAndErrorsBeginWithItsPath) {
    const std::string path =
        testing::TempDir() + "touchline-map-" + std::to_string(::getpid()) + ".svg";
    const TactileMap map = parsed(svg("<circle id='c' cx='50' cy='40' r='30'/>"));
    ASSERT_TRUE(write_whole_file(path, format_map_svg(map)));
    const auto read = read_map_svg(path);
    ::unlink(path.c_str());
    ASSERT_TRUE(read) << read.error().line;
    expect_same(*read, map);
    const auto gone = read_map_svg(path);
    ASSERT_FALSE(gone);
    EXPECT_TRUE(gone.error().line.starts_with(path + ": "));
}

TEST(MapSvg, NumbersAreTheShortestThatReadBack) {
    EXPECT_EQ(svg_number(0.1), "0.1");
    EXPECT_EQ(svg_number(116.0), "116");
    EXPECT_EQ(svg_number(-1e-7), "-1e-07");
    EXPECT_EQ(path_data(on_page({{1, 2.5}, {3, 4}, {5, 6}}), true, page), "M1 2.5 L3 4 L5 6 Z");
}

std::string drawn_text() {
    const std::vector<std::string> words{"fin", "<b>", "\"it's\"", "&amp;", "\xc3\xbc", "a]]>b"};
    std::string text;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        if (!text.empty()) text += ' ';
        text += *rc::gen::elementOf(words);
    }
    return text;
}

/// A map of points from `make`, no two equal in a row, and with distinct ends.
template <class Make>
TactileMap drawn_map(const Area& area, const Make& make) {
    TactileMap map;
    map.area = area;
    map.title = drawn_text();
    map.description = drawn_text();
    const int outlines = *rc::gen::inRange(1, 5);
    for (int k = 0; k < outlines; ++k) {
        Outline outline;
        const int count = *rc::gen::inRange(4, 40);
        for (int i = 0; i < count; ++i) {
            const Position p = make();
            if (outline.points.empty() || norm(p - outline.points.back()) > 1e-8) {
                outline.points.push_back(p);
            }
        }
        RC_PRE(outline.points.size() > 2U);
        RC_PRE(norm(outline.points.back() - outline.points.front()) > 1e-8);
        outline.is_closed = *rc::gen::arbitrary<bool>();
        outline.id = "part-" + std::to_string(k);
        outline.label = drawn_text();
        outline.weight = *rc::gen::inRange(1, 1000) / 300.0;
        outline.detail = *rc::gen::inRange(1, 6);
        map.outlines.push_back(outline);
    }
    map.labels.push_back({"label " + drawn_text(), make()});
    map.labels.back().text =
        map.labels.back().text.substr(0, map.labels.back().text.find_last_not_of(' ') + 1);
    return map;
}

double drawn_mm(int low_um, int high_um) {
    return *rc::gen::inRange(low_um, high_um) / 1000.0 + *rc::gen::inRange(0, 1000000) / 1e9;
}

RC_GTEST_PROP(MapSvg, ACanonicalMapReadsBackBitForBit, ()) {
    const Area area = area_of(
        view_box_of(Area{drawn_mm(20000, 300000) / 1000.0, drawn_mm(20000, 300000) / 1000.0}));
    const TactileMap map = drawn_map(area, [&] {
        return canonical_point(drawn_mm(-10000, 320000), drawn_mm(-10000, 320000), area);
    });
    const auto read = parse_map_svg(format_map_svg(map));
    RC_ASSERT(read);
    expect_same(*read, map);
    RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(MapSvg, AnyMapReadsBackWithinAFemtometre, ()) {
    const TactileMap map = drawn_map(Area{}, [&] {
        return Position{*rc::gen::inRange(-1000000007, 1000000007) / 1.7e10,
                        *rc::gen::inRange(-1000000007, 1000000007) / 2.3e10};
    });
    const auto read = parse_map_svg(format_map_svg(map));
    RC_ASSERT(read);
    RC_ASSERT(read->outlines.size() == map.outlines.size());
    for (std::size_t k = 0; k < map.outlines.size(); ++k) {
        const auto& points = read->outlines[k].points;
        RC_ASSERT(points.size() == map.outlines[k].points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            RC_ASSERT(norm(points[i] - map.outlines[k].points[i]) <= 1e-15);
        }
    }
}

}  // namespace
}  // namespace touchline
