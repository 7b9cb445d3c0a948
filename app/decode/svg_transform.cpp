#include "app/decode/svg_transform.h"

#include "app/decode/svg_scanner.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace touchline::decode {
namespace {

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
    std::size_t kind = 0;
    while (kind < names.size() && !scanner.take_word(names[kind])) ++kind;
    const auto arguments = take_arguments(scanner);
    if (!arguments) return std::nullopt;
    const auto& v = arguments->value;
    const std::size_t count = arguments->count;
    switch (kind) {
        case 0:
            if (count == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
            break;
        case 1:
            if (count == 1 || count == 2) return Affine{1, 0, 0, 1, v[0], v[1]};
            break;
        case 2:
            if (count == 1) return Affine{v[0], 0, 0, v[0], 0, 0};
            if (count == 2) return Affine{v[0], 0, 0, v[1], 0, 0};
            break;
        case 3:
            if (count == 1 || count == 3) return rotation(v[0], v[1], v[2]);
            break;
        case 4:
            if (count == 1) return Affine{1, 0, std::tan(radians(v[0])), 1, 0, 0};
            break;
        case 5:
            if (count == 1) return Affine{1, std::tan(radians(v[0])), 0, 1, 0, 0};
            break;
        default:
            break;
    }
    return std::nullopt;
}

}  // namespace

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
