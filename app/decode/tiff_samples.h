// Private to app/decode: the numbers in a TIFF, of any depth and kind, and what of them is bright.
// Threads: pure functions.
#pragma once

#include "app/decode/formats.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline::decode {

enum class NumberKind : std::uint8_t { whole, signed_whole, floating };

struct SampleForm {
    NumberKind kind = NumberKind::whole;
    unsigned bits = 8;
};

/// Whole numbers of 1 to 32 and of 64 bits, floating ones of 16, 24, 32 and 64.
[[nodiscard]] bool is_known(const SampleForm& form);

/// As many numbers as there are places for and bytes; 0 for what is missing. Those of 16, 24, 32
/// and 64 bits are in the machine's order, others packed without gaps, the highest bit first.
void unpack(Bytes stored, const SampleForm& form, std::span<float> numbers);

/// What becomes black, and what white.
struct Range {
    float low = 0.0F;
    float high = 1.0F;
};

/// All that the kind can hold; floating: 0 to 1.
[[nodiscard]] Range own_range(const SampleForm& form);

/// Grows with numbers, but for those that stand for none: NaN, infinite, beyond 10^30.
class Seen {
  public:
    void add(float number);

    /// The own range of the form, unless what was seen lies beyond it, or in so small a part that
    /// nobody would see it: measurements are stored so, and 12 bits in 16.
    [[nodiscard]] Range range(const SampleForm& form) const;

  private:
    float least_ = 0.0F;
    float most_ = 0.0F;
    bool has_any_ = false;
};

/// 0 ... 255; NaN: 0.
[[nodiscard]] std::uint8_t level(float number, const Range& range);

}  // namespace touchline::decode
