#include "app/documents/decode/tiff.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace touchline::decode {
namespace {

static_assert(std::endian::native == std::endian::little);

/// A number of the machine's own types, or of three bytes.
template <class Number, std::size_t bytes = sizeof(Number)>
Number stored_at(Bytes stored, std::size_t i) {
    Number number{};
    std::memcpy(&number, stored.data() + i * bytes, bytes);
    return number;
}

/// A floating number of another width, by IEEE's rules.
float floating(std::uint32_t stored, unsigned exponent_bits, unsigned fraction_bits) {
    const std::uint32_t fraction = stored & ((1U << fraction_bits) - 1U);
    const std::uint32_t most = (1U << exponent_bits) - 1U;
    const std::uint32_t exponent = stored >> fraction_bits & most;
    const bool is_negative = (stored >> (fraction_bits + exponent_bits) & 1U) != 0;
    const int bias = static_cast<int>(most >> 1U);
    if (exponent == most) return std::numeric_limits<float>::quiet_NaN();
    const bool is_small = exponent == 0;
    const std::uint32_t whole = is_small ? fraction : fraction | 1U << fraction_bits;
    const int power =
        std::max(static_cast<int>(exponent), 1) - bias - static_cast<int>(fraction_bits);
    const float number = std::ldexp(static_cast<float>(whole), power);
    return is_negative ? -number : number;
}

/// Reads numbers of any bits, one after the other.
class BitReader {
  public:
    explicit BitReader(Bytes stored) : stored_(stored) {}

    std::uint32_t next(unsigned bits) {
        while (held_bits_ < bits) {
            held_ =
                held_ << 8U | (at_ < stored_.size() ? std::to_integer<unsigned>(stored_[at_]) : 0U);
            ++at_;
            held_bits_ += 8;
        }
        held_bits_ -= bits;
        return static_cast<std::uint32_t>(held_ >> held_bits_ & ((std::uint64_t{1} << bits) - 1U));
    }

  private:
    Bytes stored_;
    std::size_t at_ = 0;
    std::uint64_t held_ = 0;
    unsigned held_bits_ = 0;
};

/// The highest bit is the sign.
float signed_number(std::uint32_t stored, unsigned bits) {
    const std::uint32_t sign = 1U << (bits - 1);
    return static_cast<float>(static_cast<double>(stored ^ sign) - static_cast<double>(sign));
}

void unpack_bits(Bytes stored, const SampleForm& form, std::span<float> numbers) {
    BitReader reader(stored);
    const bool is_signed = form.kind == NumberKind::signed_whole;
    for (float& number : numbers) {
        const std::uint32_t bits = reader.next(form.bits);
        number = is_signed ? signed_number(bits, form.bits) : static_cast<float>(bits);
    }
}

template <class Each>
void unpack_each(std::span<float> numbers, const Each& each) {
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(each(i));
}

void unpack_floating(Bytes stored, unsigned bits, std::span<float> numbers) {
    switch (bits) {
        case 16:
            return unpack_each(numbers, [stored](std::size_t i) {
                return floating(stored_at<std::uint16_t>(stored, i), 5, 10);
            });
        case 24:
            return unpack_each(numbers, [stored](std::size_t i) {
                return floating(stored_at<std::uint32_t, 3>(stored, i), 7, 16);
            });
        case 32:
            return unpack_each(numbers,
                               [stored](std::size_t i) { return stored_at<float>(stored, i); });
        default:
            return unpack_each(numbers, [stored](std::size_t i) {
                constexpr double most = std::numeric_limits<float>::max();
                return std::clamp(stored_at<double>(stored, i), -most, most);
            });
    }
}

/// Whole numbers of at most 32 bits.
template <class Number, std::size_t bytes = sizeof(Number)>
void unpack_whole(Bytes stored, const SampleForm& form, std::span<float> numbers) {
    const bool is_signed = form.kind == NumberKind::signed_whole;
    unpack_each(numbers, [stored, form, is_signed](std::size_t i) {
        const auto bits = stored_at<Number, bytes>(stored, i);
        return is_signed ? signed_number(bits, form.bits) : static_cast<float>(bits);
    });
}

void unpack_long(Bytes stored, const SampleForm& form, std::span<float> numbers) {
    const bool is_signed = form.kind == NumberKind::signed_whole;
    unpack_each(numbers, [stored, is_signed](std::size_t i) {
        return is_signed ? static_cast<float>(stored_at<std::int64_t>(stored, i))
                         : static_cast<float>(stored_at<std::uint64_t>(stored, i));
    });
}

}  // namespace

bool is_known(const SampleForm& form) {
    if (form.kind == NumberKind::floating)
        return form.bits == 16 || form.bits == 24 || form.bits == 32 || form.bits == 64;
    return (form.bits >= 1 && form.bits <= 32) || form.bits == 64;
}

void unpack(Bytes stored, const SampleForm& form, std::span<float> numbers) {
    const std::size_t there = std::min(numbers.size(), 8 * stored.size() / form.bits);
    std::ranges::fill(numbers.subspan(there), 0.0F);
    numbers = numbers.first(there);
    if (form.kind == NumberKind::floating) return unpack_floating(stored, form.bits, numbers);
    switch (form.bits) {
        case 8:
            return unpack_whole<std::uint8_t>(stored, form, numbers);
        case 16:
            return unpack_whole<std::uint16_t>(stored, form, numbers);
        case 24:
            return unpack_whole<std::uint32_t, 3>(stored, form, numbers);
        case 32:
            return unpack_whole<std::uint32_t>(stored, form, numbers);
        case 64:
            return unpack_long(stored, form, numbers);
        default:
            return unpack_bits(stored, form, numbers);
    }
}

Range own_range(const SampleForm& form) {
    const int bits = static_cast<int>(form.bits);
    switch (form.kind) {
        case NumberKind::whole:
            return {0.0F, static_cast<float>(std::ldexp(1.0, bits) - 1.0)};
        case NumberKind::signed_whole:
            return {static_cast<float>(-std::ldexp(1.0, bits - 1)),
                    static_cast<float>(std::ldexp(1.0, bits - 1) - 1.0)};
        case NumberKind::floating:
            break;
    }
    return {};
}

void Seen::add(float number) {
    constexpr float most_believed = 1e30F;
    if (!(std::abs(number) <= most_believed)) return;
    least_ = has_any_ ? std::min(least_, number) : number;
    most_ = has_any_ ? std::max(most_, number) : number;
    has_any_ = true;
}

Range Seen::range(const SampleForm& form) const {
    constexpr float smallest_part = 1.0F / 15.0F;
    const Range own = own_range(form);
    if (!has_any_ || !(most_ > least_)) return own;
    const bool is_beyond = least_ < own.low || most_ > own.high;
    const bool is_seen = most_ - least_ > smallest_part * (own.high - own.low);
    return !is_beyond && is_seen ? own : Range{least_, most_};
}

std::uint8_t level(float number, const Range& range) {
    const float part = 255.0F * (number - range.low) / (range.high - range.low);
    if (!(part > 0.0F)) return 0;
    return static_cast<std::uint8_t>(std::min(part, 255.0F) + 0.5F);
}

}  // namespace touchline::decode
