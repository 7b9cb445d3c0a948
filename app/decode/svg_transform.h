// Private to app/decode: the transform attribute of SVG. Threads: pure functions.
#pragma once

#include "config/types/vec2.h"

#include <optional>
#include <string_view>

namespace touchline::decode {

using UserPoint = Vec2<struct UserUnit>;  // in an SVG; millimetres of a map once transformed

/// x' = a x + c y + e, y' = b x + d y + f, as SVG's matrix(a b c d e f).
struct Affine {
    double a = 1.0;
    double b = 0.0;
    double c = 0.0;
    double d = 1.0;
    double e = 0.0;
    double f = 0.0;

    friend bool operator==(const Affine&, const Affine&) = default;

    [[nodiscard]] UserPoint operator()(UserPoint p) const {
        return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
    }

    /// The largest factor by which a length grows: the greater singular value.
    [[nodiscard]] double stretch() const;
};

/// Applies `inner`, then `outer`.
[[nodiscard]] Affine operator*(const Affine& outer, const Affine& inner);

/// Reads matrix, translate, scale, rotate, skewX and skewY, in any number; the empty text is the
/// identity. Returns nothing if the text is no transform.
[[nodiscard]] std::optional<Affine> parse_svg_transform(std::string_view text);

}  // namespace touchline::decode
