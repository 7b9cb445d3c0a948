#include "tests/haptics/contact/small_worlds.h"

#include "tests/exact/orientation.h"
#include "tests/haptics/scenes.h"

#include <algorithm>

namespace touchline::small_worlds {
namespace {

constexpr int side = 3;
constexpr int places = side * side;

Position position_of(int place) {
    const int half = side / 2;
    return {pitch_m * (place % side - half), pitch_m * (place / side - half)};
}

/// The grid mirrored (bit 0), turned by half (bit 1) and by a quarter (bit 2).
int image_of(int place, int symmetry) {
    int x = place % side;
    int y = place / side;
    if ((symmetry & 1) != 0) x = side - 1 - x;
    if ((symmetry & 2) != 0) y = side - 1 - y;
    if ((symmetry & 4) != 0) std::swap(x, y);
    return side * y + x;
}

/// One world stands for all that turn or mirror into each other.
bool is_first_of_images(const std::vector<int>& world) {
    for (int symmetry = 1; symmetry < 8; ++symmetry) {
        std::vector<int> image;
        for (const int place : world) image.push_back(image_of(place, symmetry));
        if (image < world) return false;
    }
    return true;
}

Outline outline_of(const std::vector<int>& world, bool is_closed) {
    std::vector<Position> points;
    for (const int place : world) points.push_back(position_of(place));
    return scenes::outline(std::move(points), is_closed);
}

std::vector<std::vector<int>> different_segments() {
    std::vector<std::vector<int>> found;
    for (int a = 0; a < places; ++a) {
        for (int b = 0; b < places; ++b) {
            if (a != b) found.push_back({a, b});
        }
    }
    return found;
}

}  // namespace

std::vector<TactileMap> polylines() {
    std::vector<TactileMap> found;
    for (const auto& first : different_segments()) {
        if (is_first_of_images(first)) {
            found.push_back(scenes::map_of({outline_of(first, false)}));
            found.push_back(scenes::map_of({outline_of(first, true)}));
        }
        for (int c = 0; c < places; ++c) {
            const std::vector<int> world{first[0], first[1], c};
            if (c == first[1] || !is_first_of_images(world)) continue;
            found.push_back(scenes::map_of({outline_of(world, false)}));
            if (c != first[0]) found.push_back(scenes::map_of({outline_of(world, true)}));
        }
    }
    return found;
}

std::vector<TactileMap> pairs() {
    std::vector<TactileMap> found;
    const auto segments = different_segments();
    for (const auto& a : segments) {
        for (const auto& b : segments) {
            if (!is_first_of_images({a[0], a[1], b[0], b[1]})) continue;
            found.push_back(scenes::map_of({outline_of(a, false), outline_of(b, false)}));
        }
    }
    return found;
}

std::vector<TactileMap> near_meetings() {
    std::vector<TactileMap> found;
    for (const TactileMap& pair : pairs()) {
        const auto& a = pair.outlines[0].points;
        const auto& b = pair.outlines[1].points;
        if (!exact::meet(a[0], a[1], b[0], b[1])) continue;
        for (const double gap_m : {1e-12, 3e-11, 1e-8, 1e-5}) {
            for (const Position aside : {Position{gap_m, 0.6 * gap_m}, {-gap_m, 0.0}}) {
                found.push_back(pair);
                for (Position& p : found.back().outlines[1].points) p += aside;
            }
        }
    }
    return found;
}

std::vector<Position> handles() {
    std::vector<Position> found;
    for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            found.push_back(pitch_m * Position{x, y});
        }
    }
    for (const double x : {-1.37, 0.21, 1.13}) {
        for (const double y : {-1.37, 0.21, 1.13}) found.push_back(pitch_m * Position{x, y});
    }
    return found;
}

}  // namespace touchline::small_worlds
