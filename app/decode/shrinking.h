// Private to app/decode: pictures of more pixels than are kept, made smaller while they are read.
// Threads: one object, one thread.
#pragma once

#include "app/decode/picture.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace touchline::decode {

/// Pixels of the file per pixel that is kept, along each side: 1, 2, 4 or 8. Sides from 1 to
/// max_file_side_px.
[[nodiscard]] unsigned reduction_for(std::uint64_t width, std::uint64_t height);

/// A side of the file as it is kept: the last pixel may stand for fewer than the others.
[[nodiscard]] constexpr std::uint64_t reduced_side(std::uint64_t side, unsigned reduction) {
    return (side + reduction - 1) / reduction;
}

/// Which pixels of its row a stretch of pixels is: every `step`th from `first`.
struct Columns {
    std::size_t first = 0;
    std::size_t step = 1;
};

/// Rows of the file go in, in any order, and never all of them are held at once: each pixel that is
/// kept is the mean of a square of the file's.
class Shrinking {
  public:
    /// Three channels (blue, green, red), or four with straight alpha. Sides within
    /// check_file_size(). Throws std::bad_alloc.
    Shrinking(std::size_t width, std::size_t height, std::size_t channels);

    /// Pixels of the row `y`, each given once; those beyond the right side are left out.
    void add_row(std::size_t y, std::span<const std::uint8_t> pixels, Columns columns = {});

    /// The picture, over the ground that shows it where there is alpha. What was not given is black
    /// or, where there is alpha, clear.
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
    std::vector<std::uint16_t> sums_;  // of 64 pixels at most; colours weighted with their alpha
};

}  // namespace touchline::decode
