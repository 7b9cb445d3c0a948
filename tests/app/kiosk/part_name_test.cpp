#include "app/kiosk/picture_facts.h"
#include "config/types/face_part.h"
#include "vision/simplify/parts.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

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
