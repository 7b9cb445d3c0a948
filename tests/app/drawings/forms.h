// Closed forms that SVG can write in many ways, and where their lines run.
// Threads: pure functions of the chance.
#pragma once

#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/chance.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::testing {

struct Form {
    Polyline line;        // in the element's units
    std::string element;  // without the closing "/>"
};

inline constexpr int form_kinds = 10;

/// Returns a circle, ellipse, rectangle, rounded rectangle, polygon, star, smooth curves, quadratic
/// curves, sector of a circle or stairs, in this order; corners have 30 degrees or more, sides a
/// fifth of the radius or more.
[[nodiscard]] Form form_of_kind(int kind, Chance& chance, cv::Point2d centre, double radius);

[[nodiscard]] Form any_form(Chance& chance, cv::Point2d centre, double radius);

/// Returns the element with these attributes, closed.
[[nodiscard]] std::string with(const Form& form, std::string_view attributes);

/// Returns an open stroke: straight sides, a wave or an arc, from left to right.
[[nodiscard]] Form open_form(Chance& chance, cv::Point2d centre, double radius);

/// Returns a star whose one line crosses itself: the fill rule makes its middle full or empty.
[[nodiscard]] Polyline crossing_star(Chance& chance, cv::Point2d centre, double radius);

}  // namespace touchline::testing
