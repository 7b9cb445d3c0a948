#include "app/kiosk/picture_facts.h"

#include "audio-cues/words/part_name.h"
#include "config/types/thing_name.h"
#include "vision/simplify/simplify.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

LoadedScene house() {
    auto map = std::make_shared<TactileMap>();
    map->version = 7;
    map->description = "From the front.";
    map->outlines.push_back({{{-0.02, 0.0}, {0.02, 0.0}}, false, "a", "wall", 1.0, 1});
    map->outlines.push_back({{{0.0, 0.01}, {0.01, 0.02}}, false, "b", "", 1.0, 2});
    map->outlines.push_back({{{0.0, 0.02}, {0.01, 0.03}}, false, "c", "wall", 1.0, 2});
    map->labels = {{"door", {0.0, -0.02}}, {"", {0.0, 0.0}}};
    LoadedScene scene;
    scene.felt.map = std::move(map);
    scene.facts.title = "IMG_2041.jpg";
    scene.facts.outline_count = 3;
    scene.facts.place = {2, 5, 1, 3};
    return scene;
}

PictureFile of_file(const std::string& name) {
    return {"", "", "", true, {}, name};
}

TEST(PictureFacts, AFileIsCalledByItsNameAndItsOwnTitleBeginsTheDescription) {
    LoadedScene scene = house();
    const PictureFile file{"house 5.svg", "house 5", "", true, {}, "house 5.svg"};
    const auto facts = [&](const std::string& title) {
        scene.facts.title = title;
        return facts_of(scene, file, {}, Language());
    };
    EXPECT_EQ(facts("The house (of 1950)").title, "house 5");
    EXPECT_EQ(facts("The house (of 1950)").description, "The house (of 1950). From the front.");
    EXPECT_EQ(facts("Our_house.svg").description, "Our house. From the front.")
        << "a program wrote it";
    for (const char* same : {"", "house 5", "House 5", "house_5", "house_5.svg"}) {
        EXPECT_EQ(facts(same).title, "house 5") << same;
        EXPECT_EQ(facts(same).description, "From the front.") << same << ": the name says it";
    }
}

TEST(PictureFacts, ThePicturesOfTheGalleryAndPhotographsHaveNoNameOfAFile) {
    LoadedScene scene = house();
    for (const char* title : {"", "A house", "SOS"}) {
        scene.facts.title = title;
        const PictureFacts facts = facts_of(scene, of_file(""), {}, Language());
        EXPECT_EQ(facts.title, title);
        EXPECT_EQ(facts.description, "From the front.");
    }
}

/// The list says "photo 20 41, J P G", because there is a "photo 20 41, H E I C" too.
TEST(PictureFacts, TheNameOfAFileIsSaidAsItsListSaysIt) {
    LoadedScene scene = house();
    const PictureFile file{"IMG_2041.jpg", "IMG_2041", "", true, {}, "IMG_2041.jpg"};
    const auto title = [&](const NameForm& form) {
        return facts_of(scene, file, form, Language()).title;
    };
    for (const char* in_file : {"IMG_2041", "IMG_2041.jpg", "DSC02041"}) {
        scene.facts.title = in_file;
        EXPECT_EQ(title({}), "photo 20 41") << in_file;
        EXPECT_EQ(title({NameDetail::with_ending}), "photo 20 41, J P G") << in_file;
        EXPECT_EQ(title({NameDetail::whole, 2}), "I M G 20 41, J P G, number 2") << in_file;
    }
}

TEST(PictureFacts, NamesOfLinesOnceThenSpots) {
    const PictureFacts facts = facts_of(house(), of_file(""), {}, Language());
    EXPECT_EQ(facts.place, (PagePlace{2, 5, 1, 3}));
    ASSERT_EQ(facts.parts.size(), 2U);
    EXPECT_EQ(facts.parts[0].name, "wall");
    EXPECT_EQ(facts.parts[0].outline, 0);
    EXPECT_EQ(facts.parts[0].place_W, (Position{-0.02, 0.0})) << "on it";
    EXPECT_EQ(facts.parts[0].middle_W, (Position{0.0, 0.0}));
    EXPECT_EQ(facts.parts[1].name, "door");
    EXPECT_FALSE(facts.parts[1].outline);
    EXPECT_EQ(facts.parts[1].middle_W, (Position{0.0, -0.02}));
}

TEST(PictureFacts, LinesThatTracingNamedAreNamedInTheLanguage) {
    const auto german = Language::load(TOUCHLINE_CATALOGUES, "de");
    ASSERT_TRUE(german.has_value()) << german.error().line;
    LoadedScene scene = house();
    auto map = std::make_shared<TactileMap>(*scene.felt.map);
    map->outlines[0].label = "dashed line 2, upper left";
    map->outlines[1].label = "dotted line, middle";
    map->outlines[2].label = "line, of washing";
    scene.felt.map = map;
    const PictureFacts facts = facts_of(scene, of_file(""), {}, *german);
    ASSERT_EQ(facts.parts.size(), 4U);
    EXPECT_EQ(facts.parts[0].name, "gestrichelte Linie 2, oben links");
    EXPECT_EQ(facts.parts[1].name, "gepunktete Linie, in der Mitte");
    EXPECT_EQ(facts.parts[2].name, "line, of washing") << "a person's words";
    HandState hand;
    hand.map_version = 7;
    hand.outline = 0;
    EXPECT_EQ(part_at(*map, facts.parts, hand), std::optional<std::size_t>(0));
}

TEST(PictureFacts, AHandIsOnTheLineThatItTouchesElseOnASpotNearby) {
    const LoadedScene scene = house();
    const PictureFacts facts = facts_of(scene, of_file(""), {}, Language());
    HandState hand;
    hand.map_version = 7;
    hand.p_WH = {0.05, 0.03};
    EXPECT_FALSE(part_at(*scene.felt.map, facts.parts, hand));
    hand.outline = 2;
    EXPECT_EQ(part_at(*scene.felt.map, facts.parts, hand), std::optional<std::size_t>(0));
    hand.outline = 1;  // nobody named it
    EXPECT_FALSE(part_at(*scene.felt.map, facts.parts, hand));
    hand.p_WH = {0.003, -0.02};
    EXPECT_EQ(part_at(*scene.felt.map, facts.parts, hand), std::optional<std::size_t>(1));
    hand.p_WH = {0.005, -0.02};
    EXPECT_FALSE(part_at(*scene.felt.map, facts.parts, hand));
}

TEST(PictureFacts, WhatIsToldOfAnotherMapMeansNothing) {
    const LoadedScene scene = house();
    const PictureFacts facts = facts_of(scene, of_file(""), {}, Language());
    HandState hand;
    hand.p_WH = {0.05, 0.03};
    hand.map_version = 6;
    hand.outline = 0;
    EXPECT_FALSE(part_at(*scene.felt.map, facts.parts, hand));
    hand.map_version = 7;
    hand.outline = 99;
    EXPECT_FALSE(part_at(*scene.felt.map, facts.parts, hand));
}

/// All labels that tracing gives to lines.
std::set<std::string> traced_labels() {
    std::set<std::string> labels;
    for (int of = 0; of <= static_cast<int>(LineOf::background); ++of) {
        for (const bool is_closed : {false, true}) {
            TactileMap map;
            map.outlines.resize(2);
            for (Outline& outline : map.outlines) {
                outline.points = {{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.01}};
                outline.is_closed = is_closed;
            }
            label_by_place(map, {static_cast<LineOf>(of), static_cast<LineOf>(of)});
            for (const Outline& outline : map.outlines) labels.insert(outline.label);
        }
    }
    return labels;
}

TEST(PartName, WhateverTracingCallsALineHasItsNameInEveryLanguage) {
    std::set<std::string> labels = traced_labels();
    ASSERT_GT(labels.size(), 16U);
    for (const std::string_view part : face_part_ids) labels.insert(std::string(part));
    const auto codes = languages_in(TOUCHLINE_CATALOGUES).value();
    for (const std::string& code : codes) {
        if (code == "en") continue;
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language) << language.error().line;
        std::set<std::string> names;
        for (const std::string& label : labels) {
            names.insert(part_name(label, *language));
            EXPECT_FALSE(labels.contains(part_name(label, *language))) << code << ": " << label;
        }
        EXPECT_EQ(names.size(), labels.size()) << code;
    }
}

TEST(PartName, WhatAPersonWroteStays) {
    const auto language = Language::load(TOUCHLINE_CATALOGUES, "de");
    ASSERT_TRUE(language);
    for (const char* label : {"roof", "roof, left", "closed line, somewhere", "line x, left", ""})
        EXPECT_EQ(part_name(label, *language), label);
    EXPECT_EQ(part_name("left eye", *language), "linkes Auge");
    EXPECT_EQ(part_name("closed line 2, upper left", *language),
              "geschlossene Linie 2, oben links");
}

}  // namespace
}  // namespace touchline
