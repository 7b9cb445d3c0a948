#include "tests/exact/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline::exact {
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

    [[nodiscard]] int sign() const {
        if (size_ == 0) return 0;
        return parts_[size_ - 1] > 0.0 ? 1 : -1;
    }

  private:
    std::array<double, 16> parts_{};
    std::size_t size_ = 0;
};

bool in_box(Position a, Position b, Position p) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
           p.y <= std::max(a.y, b.y);
}

}  // namespace

int orientation(Position a, Position b, Position c) {
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double fast = left - right;
    if (std::abs(fast) > 1e-15 * (std::abs(left) + std::abs(right))) return fast > 0.0 ? 1 : -1;
    Expansion sum;
    sum.add_product(b.x, c.y);
    sum.add_product(-b.x, a.y);
    sum.add_product(-a.x, c.y);
    sum.add_product(-b.y, c.x);
    sum.add_product(b.y, a.x);
    sum.add_product(a.y, c.x);
    return sum.sign();
}

bool meet(Position a, Position b, Position c, Position d) {
    const int ca = orientation(a, b, c);
    const int da = orientation(a, b, d);
    const int ac = orientation(c, d, a);
    const int bc = orientation(c, d, b);
    if (ca * da < 0 && ac * bc < 0) return true;
    return (ca == 0 && in_box(a, b, c)) || (da == 0 && in_box(a, b, d)) ||
           (ac == 0 && in_box(c, d, a)) || (bc == 0 && in_box(c, d, b));
}

}  // namespace touchline::exact
