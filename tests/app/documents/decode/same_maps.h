// Compares two maps that must be the same, bit for bit. Threads: any.
#pragma once

#include "config/types/tactile_map.h"

#include <cstddef>

#include <gtest/gtest.h>

namespace touchline {

/// Expects all but the versions to be equal.
inline void expect_same(const TactileMap& a, const TactileMap& b) {
    EXPECT_EQ(a.area, b.area);
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.description, b.description);
    ASSERT_EQ(a.outlines.size(), b.outlines.size());
    for (std::size_t i = 0; i < a.outlines.size(); ++i) {
        EXPECT_EQ(a.outlines[i].points, b.outlines[i].points);
        EXPECT_EQ(a.outlines[i].is_closed, b.outlines[i].is_closed);
        EXPECT_EQ(a.outlines[i].id, b.outlines[i].id);
        EXPECT_EQ(a.outlines[i].label, b.outlines[i].label);
        EXPECT_EQ(a.outlines[i].weight, b.outlines[i].weight);
        EXPECT_EQ(a.outlines[i].detail, b.outlines[i].detail);
    }
    ASSERT_EQ(a.labels.size(), b.labels.size());
    for (std::size_t i = 0; i < a.labels.size(); ++i) {
        EXPECT_EQ(a.labels[i].text, b.labels[i].text);
        EXPECT_EQ(a.labels[i].place, b.labels[i].place);
    }
}

}  // namespace touchline
