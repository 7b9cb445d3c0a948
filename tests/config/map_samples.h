// Maps for tests of the formats that carry them.
#pragma once

#include "config/types/tactile_map.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>

namespace touchline {

/// Draws a number from 0 to count - 1.
inline std::uint32_t draw(std::mt19937& random, std::uint32_t count) {
    return static_cast<std::uint32_t>(random()) % count;
}

inline std::string random_text(std::mt19937& random) {
    static constexpr const char* words[] = {"",
                                            "fin",
                                            "\xc3\xa9toile",
                                            "\xe2\x82\xac 5",
                                            "\xf0\x9f\x90\x9f",
                                            "line\nbreak",
                                            "a longer name"};
    return words[draw(random, std::size(words))];
}

/// Returns a sound map of up to 5 outlines, with at least 2 and a label.
inline TactileMap random_map_sample(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto place = [&random] {
        const auto coordinate = [&random] {
            return (static_cast<double>(random()) / 2147483648.0 - 1.0);
        };
        return Position{coordinate(), coordinate()};
    };
    TactileMap map;
    map.area = {0.001 * (1.0 + draw(random, 999)), 0.001 * (1.0 + draw(random, 999))};
    map.title = random_text(random);
    map.description = random_text(random);
    map.version = (std::uint64_t{draw(random, 1U << 31)} << 32) | draw(random, 1U << 31);
    const unsigned outlines = 2 + draw(random, 4);
    for (unsigned i = 0; i < outlines; ++i) {
        Outline outline;
        const unsigned points = 2 + draw(random, 20);
        for (unsigned k = 0; k < points; ++k) outline.points.push_back(place());
        outline.is_closed = draw(random, 2) == 0;
        if (draw(random, 2) == 0) outline.id = "outline-" + std::to_string(i);
        outline.label = random_text(random);
        outline.weight = 0.25 * (1 + draw(random, 16));
        outline.detail = 1 + static_cast<int>(draw(random, 5));
        map.outlines.push_back(std::move(outline));
    }
    for (unsigned i = 0; i < 1 + draw(random, 3); ++i)
        map.labels.push_back({random_text(random), place()});
    return map;
}

inline bool is_same_map(const TactileMap& a, const TactileMap& b) {
    const auto same_outline = [](const Outline& p, const Outline& q) {
        return p.points == q.points && p.is_closed == q.is_closed && p.id == q.id &&
               p.label == q.label && p.weight == q.weight && p.detail == q.detail;
    };
    const auto same_label = [](const Label& p, const Label& q) {
        return p.text == q.text && p.place == q.place;
    };
    return a.area == b.area && a.title == b.title && a.description == b.description &&
           a.version == b.version &&
           std::equal(a.outlines.begin(), a.outlines.end(), b.outlines.begin(), b.outlines.end(),
                      same_outline) &&
           std::equal(a.labels.begin(), a.labels.end(), b.labels.begin(), b.labels.end(),
                      same_label);
}

/// Checks what config/types/tactile_map.h promises of a map, without the code that reads bytes.
inline bool is_sound(const TactileMap& map) {
    const auto is_near = [](Position p) { return std::abs(p.x) <= 1.0 && std::abs(p.y) <= 1.0; };
    bool sound = map.area.width_m > 0.0 && map.area.width_m <= 1.0 && map.area.height_m > 0.0 &&
                 map.area.height_m <= 1.0 && is_utf8(map.title) && is_utf8(map.description);
    std::set<std::string> ids;
    for (const Outline& outline : map.outlines) {
        sound = sound && outline.points.size() >= 2 &&
                std::all_of(outline.points.begin(), outline.points.end(), is_near) &&
                outline.weight > 0.0 && std::isfinite(outline.weight) && outline.detail >= 1 &&
                outline.detail <= 5 && is_utf8(outline.id) && is_utf8(outline.label) &&
                (outline.id.empty() || ids.insert(outline.id).second);
    }
    for (const Label& label : map.labels)
        sound = sound && is_near(label.place) && is_utf8(label.text);
    return sound;
}

}  // namespace touchline
