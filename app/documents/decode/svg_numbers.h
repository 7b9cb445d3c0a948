// Private to app/documents/decode: numbers and transforms in the attributes of SVG, whatever the
// locale. Threads: pure functions; a scanner by one thread. O(length).
#pragma once

#include "config/types/vec2.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace touchline::decode {

/// Walks over a list such as "10,20 -.5.5e1", where a sign or a point may begin the next number.
class SvgScanner {
  public:
    explicit SvgScanner(std::string_view text) : text_(text) {}

    void skip_space();

    /// Skips white space with at most one comma in it.
    void skip_separator();

    [[nodiscard]] bool is_at_end() const { return position_ == text_.size(); }

    [[nodiscard]] std::size_t position() const { return position_; }

    /// The current character, 0 at the end.
    [[nodiscard]] char peek() const { return is_at_end() ? '\0' : text_[position_]; }

    char take() { return is_at_end() ? '\0' : text_[position_++]; }

    /// Takes the word if it comes next.
    bool take_word(std::string_view word);

    /// Takes a finite number and the separator behind it; nothing if there is none.
    std::optional<double> take_number();

    /// Takes a flag of an arc: one digit, 0 or 1, which may touch what follows it.
    std::optional<double> take_flag();

  private:
    std::string_view text_;
    std::size_t position_ = 0;
};

/// Reads an attribute that is one number; "px" may follow it (it is the user unit).
[[nodiscard]] std::optional<double> parse_svg_length(std::string_view text);

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
