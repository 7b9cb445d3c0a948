// Private to app/decode: the numbers in a TIFF, of any depth and kind, and which of them are
// bright.
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

/// True for whole numbers of 1 to 32 and of 64 bits, and floating ones of 16, 24, 32 and 64.
[[nodiscard]] bool is_known(const SampleForm& form);

/// Unpacks as many numbers as there are places and bytes; missing ones become 0. Those of 16, 24,
/// 32 and 64 bits are in the machine's order; others are packed without gaps, the highest bit
/// first.
void unpack(Bytes stored, const SampleForm& form, std::span<float> numbers);

/// The numbers that become black and white.
struct Range {
    float low = 0.0F;
    float high = 1.0F;
};

/// All values of the kind; for floating ones 0 to 1.
[[nodiscard]] Range own_range(const SampleForm& form);

/// The range of the numbers seen. Ignores what stands for no number: NaN, infinite, beyond 10^30.
class Seen {
  public:
    void add(float number);

    /// The own range of the form, unless the numbers seen lie beyond it, or in so small a part of
    /// it that nobody would see it. Measurements are stored so, and 12 bits in 16.
    [[nodiscard]] Range range(const SampleForm& form) const;

  private:
    float least_ = 0.0F;
    float most_ = 0.0F;
    bool has_any_ = false;
};

/// 0 ... 255; NaN: 0.
[[nodiscard]] std::uint8_t level(float number, const Range& range);

}  // namespace touchline::decode
