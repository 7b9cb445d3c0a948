#include "app/documents/decode/svg_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <system_error>

namespace touchline::decode {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

struct Arguments {
    std::array<double, 6> value{};
    std::size_t count = 0;
};

std::optional<Arguments> take_arguments(SvgScanner& scanner) {
    Arguments arguments;
    scanner.skip_space();
    if (scanner.take() != '(') return std::nullopt;
    scanner.skip_space();
    while (scanner.peek() != ')') {
        const auto number = scanner.take_number();
        if (!number || arguments.count == arguments.value.size()) return std::nullopt;
        arguments.value[arguments.count++] = *number;
    }
    scanner.take();
    return arguments;
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

Affine rotation(double angle_deg, double x, double y) {
    const double cosine = std::cos(radians(angle_deg));
    const double sine = std::sin(radians(angle_deg));
    const Affine turn{cosine, sine, -sine, cosine, 0.0, 0.0};
    return Affine{1, 0, 0, 1, x, y} * turn * Affine{1, 0, 0, 1, -x, -y};
}

std::optional<Affine> take_one(SvgScanner& scanner) {
    constexpr std::array names{"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    const auto* const found =
        std::ranges::find_if(names, [&](const char* name) { return scanner.take_word(name); });
    const auto arguments = take_arguments(scanner);
    if (found == names.end() || !arguments) return std::nullopt;
    const auto& v = arguments->value;
    const auto is = [&](std::string_view name, std::size_t count) {
        return *found == name && arguments->count == count;
    };
    if (is("matrix", 6)) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
    if (is("translate", 1) || is("translate", 2)) return Affine{1, 0, 0, 1, v[0], v[1]};
    if (is("scale", 1)) return Affine{v[0], 0, 0, v[0], 0, 0};
    if (is("scale", 2)) return Affine{v[0], 0, 0, v[1], 0, 0};
    if (is("rotate", 1) || is("rotate", 3)) return rotation(v[0], v[1], v[2]);
    if (is("skewX", 1)) return Affine{1, 0, std::tan(radians(v[0])), 1, 0, 0};
    if (is("skewY", 1)) return Affine{1, std::tan(radians(v[0])), 0, 1, 0, 0};
    return std::nullopt;
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

double Affine::stretch() const {
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / 2.0;
}

Affine operator*(const Affine& outer, const Affine& inner) {
    const UserPoint origin = outer({inner.e, inner.f});
    return {outer.a * inner.a + outer.c * inner.b,
            outer.b * inner.a + outer.d * inner.b,
            outer.a * inner.c + outer.c * inner.d,
            outer.b * inner.c + outer.d * inner.d,
            origin.x,
            origin.y};
}

std::optional<Affine> parse_svg_transform(std::string_view text) {
    SvgScanner scanner(text);
    Affine all;
    scanner.skip_space();
    while (!scanner.is_at_end()) {
        const auto one = take_one(scanner);
        if (!one) return std::nullopt;
        all = all * *one;
        scanner.skip_separator();
    }
    return all;
}

}  // namespace touchline::decode
