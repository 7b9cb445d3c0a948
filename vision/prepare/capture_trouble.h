// Why a document was not captured, and what to do, as said to a visitor who lays it down by touch.
// Threads: pure functions.
#pragma once

#include <cstdint>
#include <string_view>

namespace touchline {

/// Directions are those in the picture; the camera looks down with its top away from the visitor.
enum class CaptureTrouble : std::uint8_t {
    none,
    too_dark,
    too_bright,
    glare,  // a lamp reflects in the page
    no_page,
    too_small,
    too_large,  // it extends beyond the picture on opposite sides
    too_far_left,
    too_far_right,
    too_far_up,
    too_far_down,
};

/// Returns at most 15 words; empty for none.
[[nodiscard]] std::string_view sentence(CaptureTrouble trouble);

}  // namespace touchline
