// Degrees, in which people and files tell angles, and radians, in which the program computes.
#pragma once

#include <numbers>

namespace touchline {

[[nodiscard]] constexpr double radians(double angle_deg) {
    return angle_deg * std::numbers::pi / 180.0;
}

[[nodiscard]] constexpr double degrees(double angle_rad) {
    return angle_rad * (180.0 / std::numbers::pi);
}

}  // namespace touchline
