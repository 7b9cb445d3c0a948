// Private to app/documents/decode: makes pictures with too many pixels smaller while they are read.
// Threads: one object, one thread.
#pragma once

#include "app/documents/decode/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline::decode {

/// Pixels of the file per kept pixel, along each side: 1, 2, 4 or 8. Sides from 1 to
/// max_file_side_px.
[[nodiscard]] unsigned reduction_for(std::uint64_t width, std::uint64_t height);

/// The kept length of a file's side. The last pixel may stand for fewer pixels than the others.
[[nodiscard]] constexpr std::uint64_t reduced_side(std::uint64_t side, unsigned reduction) {
    return (side + reduction - 1) / reduction;
}

/// The columns of a stretch of pixels in its row: every `step`th from `first`.
struct Columns {
    std::size_t first = 0;
    std::size_t step = 1;
};

/// Takes rows of the file in any order, and never holds all of them at once: each kept pixel is the
/// mean of a square of the file's pixels.
class Shrinking {
  public:
    /// Three channels (blue, green, red), or four with straight alpha. Sides within
    /// check_file_size(). Throws std::bad_alloc.
    Shrinking(std::size_t width, std::size_t height, std::size_t channels);

    /// Adds pixels of the row `y`, each given once. Leaves out those beyond the right side.
    void add_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns = {});

    /// The picture, over the background that shows it if there is alpha. Pixels that were not given
    /// are black or, with alpha, clear.
    [[nodiscard]] Picture picture() &&;

  private:
    template <std::size_t channels>
    void sum_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns);
    void keep_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns);
    [[nodiscard]] unsigned pixels_in(std::size_t x, std::size_t y) const;
    void take_means();

    std::size_t width_;
    std::size_t height_;
    std::size_t channels_;
    unsigned by_;
    unsigned shift_;  // by_ is 1 << shift_
    Picture picture_;
    std::vector<std::uint16_t> sums_;  // over at most 64 pixels; colours weighted with their alpha
};

}  // namespace touchline::decode
