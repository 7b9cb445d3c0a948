// Closed forms that SVG can write in many ways, and where their line runs. Threads: pure functions
// of the chance.
#pragma once

#include "tests/vision/pictures/canvas.h"
#include "tests/vision/pictures/chance.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline::testing {

struct Form {
    Polyline line;        // the same units as the element's
    std::string element;  // without its last "/>"
};

inline constexpr int kFormKinds = 10;

/// Circle, ellipse, rectangle, rounded rectangle, polygon, star, smooth curves, quadratic curves,
/// sector of a circle, stairs, in this order; corners of 30 degrees or more, sides of a fifth of
/// the radius or more.
[[nodiscard]] Form form_of_kind(int kind, Chance& chance, cv::Point2d centre, double radius);

[[nodiscard]] Form any_form(Chance& chance, cv::Point2d centre, double radius);

/// The element with these attributes, closed.
[[nodiscard]] std::string with(const Form& form, std::string_view attributes);

/// A stroke that is not closed: straight sides, a wave or an arc, from the left to the right.
[[nodiscard]] Form open_form(Chance& chance, cv::Point2d centre, double radius);

/// A star whose one line crosses itself: its middle is full or empty by the rule.
[[nodiscard]] Polyline crossing_star(Chance& chance, cv::Point2d centre, double radius);

}  // namespace touchline::testing
