// EXIF and TIFF use the same numbers for the eight ways of holding a camera: TIFF 6.0, tag 274.
#include "app/decode/formats.h"

#include <algorithm>
#include <utility>

namespace touchline::decode {
Picture upright(Picture picture, int orientation) {
    if (orientation < 2 || orientation > 8) return picture;
    const bool is_turned = orientation >= 5;  // rows of the file are columns of the picture
    const bool is_x_mirrored =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool is_y_mirrored =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    Picture out{picture.width, picture.height, {}, picture.scale};
    if (is_turned) std::swap(out.width, out.height);
    out.bgr.resize(picture.bgr.size());
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    std::uint8_t* to = out.bgr.data();
    for (std::size_t y = 0; y < static_cast<std::size_t>(out.height); ++y) {
        for (std::size_t x = 0; x < static_cast<std::size_t>(out.width); ++x, to += 3) {
            // The source's column and row, before the mirroring along the file's own axes.
            const std::size_t column = is_turned ? y : x;
            const std::size_t row = is_turned ? x : y;
            const std::size_t from_x = is_x_mirrored ? width - 1 - column : column;
            const std::size_t from_y = is_y_mirrored ? height - 1 - row : row;
            std::copy_n(&picture.bgr[3 * (from_y * width + from_x)], 3, to);
        }
    }
    return out;
}

}  // namespace touchline::decode
