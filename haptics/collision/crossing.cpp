#include "haptics/collision/crossing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

/// A sum of doubles kept exactly, as non-overlapping parts, smallest first.
class Expansion {
  public:
    void add(double x) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = x + parts_[i];
            const double virtual_part = sum - x;
            const double lost = (x - (sum - virtual_part)) + (parts_[i] - virtual_part);
            x = sum;
            if (lost != 0.0) parts_[kept++] = lost;
        }
        if (x != 0.0) parts_[kept++] = x;
        size_ = kept;
    }

    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    /// The value to 1 ulp; its sign is exact.
    [[nodiscard]] double value() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < size_; ++i) sum += parts_[i];
        return sum;
    }

  private:
    std::array<double, 12> parts_{};  // six products of two parts each
    std::size_t size_ = 0;
};

/// Returns twice the area of the triangle a, b, c, to 1 ulp.
double exact_area(Position a, Position b, Position c) {
    Expansion sum;
    sum.add_product(b.x, c.y);
    sum.add_product(-b.x, a.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-b.y, c.x);
    sum.add_product(b.y, a.x);
    sum.add_product(a.y, c.x);
    return sum.value();
}

bool is_between(Position a, Position b, Position p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

/// Returns where p, on the line through a and b, lies between them; 0 if they are one point.
double share_between(Position a, Position b, Position p) {
    const Position e = b - a;
    const bool is_wide = std::abs(e.x) >= std::abs(e.y);
    const double length = is_wide ? e.x : e.y;
    return length == 0.0 ? 0.0 : (is_wide ? p.x - a.x : p.y - a.y) / length;
}

/// For a way and a segment on one line, or if one of them is a point.
std::optional<Crossing> collinear_crossing(Position from, Position to, const Segment& segment) {
    if (is_between(segment.a, segment.b, from)) {
        return Crossing{0.0, share_between(segment.a, segment.b, from), true};
    }
    std::optional<Crossing> first;
    for (const double end : {0.0, 1.0}) {
        const Position p = end == 0.0 ? segment.a : segment.b;
        if (!is_between(from, to, p)) continue;
        const double fraction = share_between(from, to, p);
        if (!first || fraction < first->fraction) first = Crossing{fraction, end, true};
    }
    return first;
}

double share(double from, double to) {
    return std::abs(from) / (std::abs(from) + std::abs(to));
}

int sign_of(double x) {
    return x > 0.0 ? 1 : (x < 0.0 ? -1 : 0);
}

}  // namespace

int orientation(Position a, Position b, Position c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double fast = left - right;
    const double doubt = 4e-16 * (std::abs(left) + std::abs(right));  // 3.33e-16 after Shewchuk
    if (std::abs(fast) > doubt) return sign_of(fast);
    return sign_of(exact_area(a, b, c));
}

std::optional<Crossing> crossing(Position from, Position to, const Segment& segment) {
    const auto [a, b] = segment;
    const int side_of_from = orientation(a, b, from);
    const int side_of_to = orientation(a, b, to);
    if (side_of_from * side_of_to > 0) return {};
    const int side_of_a = orientation(from, to, a);
    const int side_of_b = orientation(from, to, b);
    if (side_of_a * side_of_b > 0) return {};
    const bool is_collinear =
        (side_of_from == 0 && side_of_to == 0) || (side_of_a == 0 && side_of_b == 0);
    if (is_collinear) return collinear_crossing(from, to, segment);
    return Crossing{share(exact_area(a, b, from), exact_area(a, b, to)),
                    share(exact_area(from, to, a), exact_area(from, to, b)), side_of_from >= 0};
}

bool passes(Position from, Position to, const Segment& segment) {
    const Position a = segment.a;
    const Position b = segment.b;
    const bool is_a_left = orientation(from, to, a) >= 0;
    const bool is_b_left = orientation(from, to, b) >= 0;
    if (is_a_left == is_b_left) return false;
    const double lean = -dot(b - a, to - from);
    const auto is_left = [&](Position p) {
        const int side = orientation(a, b, p);
        return side != 0 ? side > 0 : lean >= 0.0;
    };
    return is_left(from) != is_left(to);
}

}  // namespace touchline
