// Where the bed of a fixed camera stand lies in the camera's picture, as the operator calibrated
// it. Threads: values and pure functions.
#pragma once

#include "config/types/result.h"

#include <array>
#include <string>
#include <string_view>

namespace touchline {

struct StandSettings {
    int picture_width_px = 0;  // of the picture that it was calibrated with
    int picture_height_px = 0;
    /// x and y of upper left, upper right, lower right, lower left; the centre of the picture's
    /// upper left pixel is 0, 0.
    std::array<double, 8> bed_corners_px{};
    double bed_width_mm = 0.0;
    double bed_height_mm = 0.0;
    bool operator==(const StandSettings&) const = default;
};

/// What the text of a file holds; `name` is that file's, for the error. Malformed, a missing or
/// unknown key or a value out of range: one line with file and line number.
[[nodiscard]] Result<StandSettings> parse_stand(std::string_view text, std::string_view name);

/// The text that parse_stand() reads back to the same bits.
[[nodiscard]] std::string stand_text(const StandSettings& stand);

}  // namespace touchline
