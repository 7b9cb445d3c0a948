// The extents of a box in 8 bytes: shares of the segment's length as the upper halves of floats,
// rounded outward by less than 1 %. Threads: values.
#pragma once

#include "haptics/collision/box.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace touchline {

class PackedExtents {
  public:
    PackedExtents() = default;

    /// Holds [along_low, along_high] x [across_low, across_high], finite or not.
    PackedExtents(double along_low, double along_high, double across_low, double across_high)
        : halves_{below(along_low), above(along_high), below(across_low), above(across_high)} {}

    [[nodiscard]] double along_low() const { return value(halves_[0]); }

    [[nodiscard]] double along_high() const { return value(halves_[1]); }

    [[nodiscard]] double across_low() const { return value(halves_[2]); }

    [[nodiscard]] double across_high() const { return value(halves_[3]); }

  private:
    static double value(std::uint16_t half) {
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(half) << 16));
    }

    /// Returns the largest number of this format that is not above x.
    static std::uint16_t below(double x) {
        const auto sign = static_cast<std::uint16_t>(0x8000);
        return static_cast<std::uint16_t>(above(-x) ^ sign);
    }

    /// Returns the smallest number of this format that is not below x.
    static std::uint16_t above(double x) {
        constexpr std::uint16_t largest = 0x7f7f;
        if (!(x <= static_cast<double>(std::numeric_limits<float>::max()))) return largest;
        auto half =
            static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(static_cast<float>(x)) >> 16);
        while (value(half) < x) half = next_up(half);
        return half;
    }

    /// Rounds away from zero for positive numbers, towards it for negative ones.
    static std::uint16_t next_up(std::uint16_t half) {
        const bool is_negative = (half & 0x8000U) != 0;
        if (half == 0x8000U) return 0x0001U;
        return static_cast<std::uint16_t>(is_negative ? half - 1 : half + 1);
    }

    std::array<std::uint16_t, 4> halves_{};
};

/// Returns the box of a node in its segment's frame, with what it holds beside the segment.
[[nodiscard]] inline Box box_of(const Segment& s, const PackedExtents& e) {
    return {s.a, frame_axis(s), e.along_low(), e.along_high(), e.across_low(), e.across_high()};
}

}  // namespace touchline
