#include "app/decode/svg_scanner.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace touchline::decode {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

void SvgScanner::skip_space() {
    while (is_space(peek())) ++position_;
}

void SvgScanner::skip_separator() {
    skip_space();
    if (peek() != ',') return;
    ++position_;
    skip_space();
}

bool SvgScanner::take_word(std::string_view word) {
    if (!text_.substr(position_).starts_with(word)) return false;
    position_ += word.size();
    return true;
}

std::optional<double> SvgScanner::take_number() {
    std::string_view rest = text_.substr(position_);
    const bool has_plus = rest.starts_with('+');  // from_chars accepts only the minus
    if (has_plus) rest.remove_prefix(1);
    const std::string_view digits = !has_plus && rest.starts_with('-') ? rest.substr(1) : rest;
    // from_chars would take "inf" and "nan" as well.
    if (digits.empty() || !(is_digit(digits[0]) || digits[0] == '.')) return std::nullopt;
    double value = 0.0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    position_ = static_cast<std::size_t>(end - text_.data());
    skip_separator();
    return value;
}

std::optional<double> SvgScanner::take_flag() {
    const char c = peek();
    if (c != '0' && c != '1') return std::nullopt;
    ++position_;
    skip_separator();
    return c == '1' ? 1.0 : 0.0;
}

std::optional<double> parse_svg_length(std::string_view text) {
    SvgScanner scanner(text);
    scanner.skip_space();
    const auto value = scanner.take_number();
    if (!value) return std::nullopt;
    scanner.take_word("px");
    scanner.skip_space();
    return scanner.is_at_end() ? value : std::nullopt;
}

}  // namespace touchline::decode
