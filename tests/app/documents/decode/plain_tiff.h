// Writes TIFFs without any library, bit by bit after the specification, to test a reader.
#pragma once

#include "tests/app/documents/decode/encoders.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline::encoders {

struct PlainTiff {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    unsigned bits = 8;     // per sample
    unsigned samples = 1;  // per pixel
    unsigned photometric =
        1;  // 0 white is zero, 1 black is zero, 2 RGB, 3 palette, 5 inks, 6 YCbCr, 8 Lab
    unsigned sample_format = 1;    // 1 whole, 2 signed, 3 floating
    bool is_planar = false;        // each sample has its own plane
    std::uint32_t tile = 0;        // side length; 0: strips
    std::uint32_t strip_rows = 0;  // 0: one strip
    bool is_big_endian = false;
    unsigned orientation = 1;
    int extra_sample = -1;                 // 0 unspecified, 1 premultiplied alpha, 2 straight alpha
    std::vector<std::uint16_t> palette{};  // all reds, all greens, all blues
    std::uint32_t x_resolution = 0;        // 0: not stated
    std::uint32_t y_resolution = 0;
};

/// `stored`: the bits of every sample, pixel by pixel, rows from the top.
[[nodiscard]] Bytes plain_tiff(const PlainTiff& form, const std::vector<std::uint64_t>& stored);

}  // namespace touchline::encoders
