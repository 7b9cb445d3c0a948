// Tests main things with their worker: a handmade network takes what is red for the thing.
#include "app/documents/trace/finding_things.h"

#include "app/documents/models/networks.h"
#include "app/documents/trace/page_views.h"
#include "app/documents/trace/tracing.h"
#include "tests/app/documents/decode/encoders.h"
#include "tests/vision/figure/onnx_writer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

/// A red disc and a smaller one, 700 x 500 pixels.
Page red_discs() {
    cv::Mat bgr(500, 700, CV_8UC3, cv::Scalar(120, 130, 110));
    cv::circle(bgr, {200, 250}, 120, cv::Scalar(20, 20, 230), cv::FILLED);
    cv::circle(bgr, {560, 120}, 60, cv::Scalar(20, 20, 230), cv::FILLED);
    Page page;
    page.picture = picture_of(bgr);
    page.told.area = {0.07, 0.05};
    page.told.title = "Balls";
    page.told.description = "On a lawn.";
    return page;
}

/// Returns the shipped networks, but with one that takes red for a main thing.
const PictureNetworkFiles& files() {
    static const PictureNetworkFiles read = [] {
        auto shipped = read_picture_networks();
        EXPECT_TRUE(shipped) << shipped.error().line;
        shipped->figure = testing::written(testing::red_network());
        return std::move(*shipped);
    }();
    return read;
}

PictureNetworks networks() {
    return files().networks();
}

TEST(FindingThings, TheThingsOfAPageAreItsViewsTheLargestFirst) {
    const Page page = red_discs();
    auto things = find_main_things(page, networks());
    ASSERT_TRUE(things) << things.error().line;
    EXPECT_TRUE(things->is_sure);
    ASSERT_EQ(things->boxes.size(), 2U);
    EXPECT_NEAR(things->boxes[0].left, 80.0 / 700, 0.01);
    EXPECT_NEAR(things->boxes[0].bottom, 370.0 / 500, 0.01);
    const Page seen = with_main_things(page, std::move(*things));
    EXPECT_TRUE(has_main_things(seen));
    ASSERT_EQ(view_count(seen), 3);
    const Page first = view_of(seen, 1);
    EXPECT_NEAR(first.picture.width, 241 + 2 * 0.07 * 241, 6);
    EXPECT_EQ(first.told.title, "Balls");
    EXPECT_EQ(first.told.description, "On a lawn.");
    const auto map = trace_page(first, {.options = {.area = {}, .detail = 1}});
    ASSERT_TRUE(map) << map.error().line;
    ASSERT_EQ(map->map.outlines.size(), 1U);
    const Outline& ring = map->map.outlines.front();
    EXPECT_TRUE(ring.is_closed);
    EXPECT_NE(ring.label.find("main subject"), std::string::npos) << ring.label;
    for (const Position& p : ring.points) EXPECT_NEAR(norm(p), 0.0368, 0.0012);
}

/// The small disc lies under a hand that feels the whole picture or the large disc's view.
TEST(FindingThings, TheThingUnderAHandIsFoundByItself) {
    const Page page = red_discs();
    const double m_per_px = 0.116 / 700;
    const Position small_W{(560 - 350) * m_per_px, (250 - 120) * m_per_px};
    const PlaceInPicture place = place_in_page(page, 1, small_W);
    EXPECT_NEAR(place.x, 560.0 / 700, 1e-9);
    EXPECT_NEAR(place.y, 120.0 / 500, 1e-9);
    auto thing = find_thing_at(place, page, networks());
    ASSERT_TRUE(thing) << thing.error().line;
    EXPECT_TRUE(thing->is_sure);
    ASSERT_EQ(thing->boxes.size(), 1U);
    EXPECT_NEAR(thing->boxes[0].left, 500.0 / 700, 0.01);
    EXPECT_NEAR(thing->boxes[0].bottom, 180.0 / 500, 0.01);
    const Page seen = with_further_thing(page, *thing);
    ASSERT_EQ(view_count(seen), 2);
    const Page twice =
        with_further_thing(seen, std::move(*find_thing_at({0.28, 0.5}, page, networks())));
    ASSERT_EQ(view_count(twice), 3);
    EXPECT_GE(twice.main_things.grey[120U * 700 + 560], 128);
    EXPECT_GE(twice.main_things.grey[250U * 700 + 200], 128);
    const PlaceInPicture in_view = place_in_page(seen, 1, {});
    EXPECT_NEAR(in_view.x, 560.0 / 700, 0.01) << "the middle of the small disc's view";
    const auto nothing = find_thing_at({0.6, 0.9}, page, networks());
    ASSERT_TRUE(nothing) << nothing.error().line;
    EXPECT_FALSE(nothing->is_sure);
}

TEST(FindingThings, AMaskOfAnotherSizeIsNotTaken) {
    const Page seen = with_main_things(red_discs(), *find_main_things(red_discs(), networks()));
    MainThings liar;
    liar.mask = {1, 1, {255}};
    liar.boxes = {{0.1, 0.1, 0.2, 0.2}};
    EXPECT_EQ(with_further_thing(seen, liar).main_things.grey, seen.main_things.grey);
}

TEST(PlaceInPicture, TwoSharesAndNothingElse) {
    EXPECT_EQ(place_of(words_of({0.25, 1.0})), (PlaceInPicture{0.25, 1.0}));
    for (const std::vector<std::string>& words : {std::vector<std::string>{},
                                                  {"0.5"},
                                                  {"0.5", "0.5", "0.5"},
                                                  {"0.5", "1.1"},
                                                  {"-0.1", "0"},
                                                  {"nan", "0.5"},
                                                  {"0.5", "inf"},
                                                  {"0.5x", "0.5"},
                                                  {"", "0.5"}})
        EXPECT_FALSE(place_of(words)) << words.size();
}

TEST(FindingThings, WhereNothingStandsOutItIsNotSure) {
    Page page = red_discs();
    std::ranges::fill(page.picture.bgr, std::uint8_t{90});
    const auto things = find_main_things(page, networks());
    ASSERT_TRUE(things) << things.error().line;
    EXPECT_FALSE(things->is_sure);
    EXPECT_EQ(view_count(with_main_things(page, *things)), 1);
}

TEST(FindingThings, WithoutTheLargeNetworkTheSmallOneThatShipsFindsAThing) {
    Page page = red_discs();
    PictureNetworks some = networks();
    some.figure = {};
    const auto things = find_main_things(page, some);
    ASSERT_TRUE(things) << things.error().line;
    ASSERT_FALSE(things->boxes.empty());
    EXPECT_NEAR(things->boxes[0].left, 80.0 / 700, 0.05);
    EXPECT_NEAR(things->boxes[0].right, 320.0 / 700, 0.05);
    EXPECT_NEAR(things->boxes[0].top, 130.0 / 500, 0.05);
    EXPECT_NEAR(things->boxes[0].bottom, 370.0 / 500, 0.05);
    EXPECT_TRUE(things->faces.empty());
}

TEST(FindingThings, ANetworkThatIsNoneIsOneLine) {
    using Place = std::span<const std::byte> PictureNetworks::*;
    for (const Place place : {&PictureNetworks::figure, &PictureNetworks::names}) {
        for (const std::size_t divisor : {2U, 100U}) {
            PictureNetworks damaged = networks();
            damaged.*place = (damaged.*place).first((damaged.*place).size() / divisor);
            const auto things = find_main_things(red_discs(), damaged);
            ASSERT_FALSE(things);
            EXPECT_NE(things.error().line.find("cannot be used"), std::string::npos)
                << things.error().line;
            EXPECT_EQ(things.error().line.find('\n'), std::string::npos);
        }
    }
}

/// A square map of a face that fills it.
DrawnFace drawn_face(const ThingBox& part) {
    DrawnFace face{part, {}};
    face.map.outlines.push_back({{{-0.02, 0.0}, {0.02, 0.0}}, false, "outline-1", "mouth", 1.0, 1});
    return face;
}

TEST(FindingThings, AFaceIsAViewThatIsFeltAsItWasDrawn) {
    const Page page = red_discs();
    MainThings things = *find_main_things(page, networks());
    things.names = {{ThingName::person, things.boxes[0], 0.8},
                    {ThingName::dog, things.boxes[1], 0.7}};
    things.faces = {drawn_face({0.5, 0.6, 1.1, 1.2})};
    const Page seen = with_main_things(page, things);
    ASSERT_EQ(view_count(seen), 4) << "two things, a face, the whole";
    EXPECT_FALSE(is_face(seen, 2));
    ASSERT_TRUE(is_face(seen, 3));
    const Page face = view_of(seen, 3);
    ASSERT_EQ(face.told.outlines.size(), 1U);
    EXPECT_EQ(face.told.outlines[0].label, "mouth");
    EXPECT_EQ(face.told.title, "Balls");
    ASSERT_EQ(face.picture.width, 420);
    ASSERT_EQ(face.picture.height, 300);
    const auto grey_at = [&face](int x, int y) {
        return face.picture.bgr[3U * static_cast<std::size_t>(420 * y + x)];
    };
    EXPECT_EQ(grey_at(0, 0), page.picture.bgr[3U * (700U * 300U + 350U)]);
    EXPECT_EQ(grey_at(349, 199), page.picture.bgr[3U * (700U * 499U + 699U)]);
    EXPECT_EQ(grey_at(350, 0), 255) << "beside the picture";
    EXPECT_EQ(grey_at(0, 200), 255) << "below the picture";
    const PlaceInPicture middle = place_in_page(seen, 3, {});
    EXPECT_NEAR(middle.x, 0.8, 1e-9);
    EXPECT_NEAR(middle.y, 0.9, 1e-9);
    EXPECT_EQ(names_told(seen, 1).size(), 2U) << "the first view tells of the whole";
    ASSERT_EQ(names_told(seen, 2).size(), 1U);
    EXPECT_EQ(names_told(seen, 2).front().name, ThingName::dog);
    EXPECT_TRUE(names_told(seen, 3).empty());
    EXPECT_EQ(names_told(seen, 4).size(), 2U);
}

TEST(FindingThings, AFaceThatIsMostOfAThingTakesItsPlace) {
    MainThings things = *find_main_things(red_discs(), networks());
    things.faces = {drawn_face(things.boxes[0])};
    const Page seen = with_main_things(red_discs(), things);
    ASSERT_EQ(view_count(seen), 3);
    EXPECT_TRUE(is_face(seen, 1));
    EXPECT_FALSE(is_face(seen, 2));
    things.faces = {drawn_face({0.4, 0.0, 1.0, 0.9})};
    EXPECT_EQ(view_count(with_main_things(red_discs(), things)), 4)
        << "a small thing beside a face stays";
}

TEST(FindingThings, ALargePictureIsShownSmallerBesideADrawnFace) {
    Page page = red_discs();
    MainThings things;
    things.faces = {drawn_face({-4.0, 0.0, 1.0, 5.0})};
    const Page face = view_of(with_main_things(page, things), 1);
    EXPECT_EQ(face.picture.width, 1750) << "3500 pixels, every second one";
    EXPECT_EQ(face.picture.height, 1250);
    EXPECT_EQ(face.picture.bgr.size(), 3U * 1750U * 1250U);
    EXPECT_EQ(face.picture.bgr[3U * 1400U], page.picture.bgr[0]);
}

TEST(FindingThings, FacesAreViewsWhereNoMainThingIsSure) {
    MainThings things = *find_main_things(red_discs(), networks());
    things.is_sure = false;
    things.faces = {drawn_face({0.1, 0.1, 0.4, 0.4})};
    const Page seen = with_main_things(red_discs(), things);
    ASSERT_EQ(view_count(seen), 2);
    EXPECT_TRUE(has_main_things(seen));
    EXPECT_TRUE(seen.main_things.grey.empty());
    EXPECT_TRUE(trace_page(seen, {}));
}

TEST(FindingThings, WhatAWorkerAnswersIsNotBelieved) {
    MainThings things;
    things.mask = {2, 2, {0, 128, 255, 0}};
    things.boxes = {{0.0, 0.0, 0.5, 1.0}};
    things.signs = {0.5, 0.9};
    things.is_sure = true;
    things.names = {{ThingName::boat, {0.1, 0.2, 0.3, 0.4}, 0.7}};
    things.faces = {drawn_face({-0.5, 0.0, 0.5, 1.5})};
    const std::vector<std::byte> right = *bytes_of(things);
    const auto back = main_things_of(right);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->boxes, things.boxes);
    EXPECT_EQ(back->names, things.names);
    ASSERT_EQ(back->faces.size(), 1U);
    EXPECT_EQ(back->faces[0].part, things.faces[0].part);
    EXPECT_EQ(back->faces[0].map.outlines[0].label, "mouth");
    EXPECT_EQ(back->mask.grey, things.mask.grey);
    EXPECT_TRUE(back->is_sure);
    for (std::size_t size = 0; size < right.size(); ++size)
        EXPECT_FALSE(main_things_of(std::span(right).first(size))) << size;
    std::vector<std::byte> longer = right;
    longer.push_back({});
    EXPECT_FALSE(main_things_of(longer));
    for (const ThingBox& box : {ThingBox{0.5, 0.0, 0.5, 1.0}, ThingBox{-0.1, 0.0, 0.5, 1.0},
                                ThingBox{0.0, 0.0, 0.5, std::nan("")}}) {
        MainThings lie = things;
        lie.boxes = {box};
        EXPECT_FALSE(main_things_of(*bytes_of(lie)));
        lie = things;
        lie.names[0].box = box;
        EXPECT_FALSE(main_things_of(*bytes_of(lie)));
    }
    for (const ThingBox& part :
         {ThingBox{0.5, 0.0, 0.5, 1.0}, ThingBox{1.0, 0.0, 1.5, 1.0}, ThingBox{-4.1, 0.0, 1.0, 1.0},
          ThingBox{-1e9, 0.0, 0.5, 1e-9}, ThingBox{0.0, 0.0, 0.5, std::nan("")},
          ThingBox{0.0, 0.0, 1.0, HUGE_VAL}}) {
        MainThings lie = things;
        lie.faces[0].part = part;
        EXPECT_FALSE(main_things_of(*bytes_of(lie)));
    }
    MainThings lie = things;
    lie.names[0].name = static_cast<ThingName>(thing_name_count);
    EXPECT_FALSE(main_things_of(*bytes_of(lie)));
    lie = things;
    lie.names[0].likelihood = std::nan("");
    EXPECT_FALSE(main_things_of(*bytes_of(lie)));
    lie = things;
    lie.faces[0].map.outlines.clear();
    EXPECT_FALSE(main_things_of(*bytes_of(lie)));
    for (const auto& say : std::vector<std::function<void(TactileMap&)>>{
             [](TactileMap& map) { map.outlines[0].label = "aged forty"; },
             [](TactileMap& map) {
                 map.labels = {{"aged forty", {}}};
             },
             [](TactileMap& map) { map.title = "aged forty"; },
             [](TactileMap& map) { map.description = "aged forty"; }}) {
        lie = things;
        say(lie.faces[0].map);
        EXPECT_FALSE(main_things_of(*bytes_of(lie))) << "what a face's map says is spoken";
    }
}

}  // namespace
}  // namespace touchline
