// Why a document was not taken, and what to do: said to somebody who lays it down by touch.
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
    glare,  // a lamp is mirrored in the page
    no_page,
    too_small,
    too_large,  // it leaves the picture on opposite sides
    too_far_left,
    too_far_right,
    too_far_up,
    too_far_down,
};

/// At most 15 words; empty for none.
[[nodiscard]] std::string_view sentence(CaptureTrouble trouble);

}  // namespace touchline
