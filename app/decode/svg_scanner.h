// Private to app/decode: reads numbers from SVG attributes, whatever the locale. O(length).
#pragma once

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

}  // namespace touchline::decode
