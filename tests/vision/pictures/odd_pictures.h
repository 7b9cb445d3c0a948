// Small and odd pictures from any bytes: what any stick may hold, and a fuzzer mutates.
// Threads: pure functions; a ByteReader belongs to one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline::testing {

/// Reads bytes one by one; zeros after the last.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] int byte() {
        if (bytes_.empty()) return 0;
        const int value = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return value;
    }

    /// Returns one of `count` things, 1 <= count <= 256.
    [[nodiscard]] int choice(int count) { return byte() % count; }

    /// Returns 0 ... 1.
    [[nodiscard]] double share() { return byte() / 255.0; }

    [[nodiscard]] std::span<const std::uint8_t> rest() const { return bytes_; }

  private:
    std::span<const std::uint8_t> bytes_;
};

/// Random numbers from a seed: the same on every machine.
class SplitMix {
  public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    [[nodiscard]] std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    /// Returns 0 ... count - 1.
    [[nodiscard]] int below(int count) {
        return static_cast<int>(next() % static_cast<std::uint64_t>(count));
    }

  private:
    std::uint64_t state_;
};

/// Returns an 8-bit picture, BGR or grey, of 1 to 200 pixels a side, or a strip: one pixel across,
/// or 16 to 23 across and up to 2040 long. Its pixels are the bytes themselves or follow rules that
/// the bytes choose: hue ramps, stripes, gradients encoded with a gamma, bands of ramps, checkers,
/// noise, dots, discs and rings, blocks like text, pen strokes, squares of many colours, one
/// colour; plain, inverted, blurred, in few colours, noisy, or two kinds side by side.
[[nodiscard]] cv::Mat odd_picture(ByteReader& bytes);

/// Returns the bytes for the n-th of many odd pictures, most of them small; begins with `before`
/// random bytes.
[[nodiscard]] std::vector<std::uint8_t> random_picture_bytes(std::uint64_t seed, int n, int before);

}  // namespace touchline::testing
