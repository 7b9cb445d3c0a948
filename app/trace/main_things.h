// What a worker answers that looked for the main things of a photograph. Nobody who reads it trusts
// it.
//
//   header  magic u32, is_sure u32, boxes u32, bytes of the mask u32, two numbers (FigureSigns)
//   boxes   four f64 each
//   mask    grey_bytes.h
//
// Threads: pure functions.
#pragma once

#include "app/decode/picture.h"
#include "config/types/result.h"
#include "vision/figure/figures.h"

#include <cstddef>
#include <span>
#include <vector>

namespace touchline {

/// A thing's place, as shares of the picture's width and height from its upper left corner.
struct ThingBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    friend bool operator==(const ThingBox&, const ThingBox&) = default;
};

struct MainThings {
    GreyPicture mask;             // of the picture's proportions; 128 and more: a thing
    std::vector<ThingBox> boxes;  // the largest thing first
    FigureSigns signs;
    bool is_sure = false;
};

[[nodiscard]] MainThings main_things_of(const Figures& figures);

[[nodiscard]] std::vector<std::byte> bytes_of(const MainThings& things);

/// Fails, with one line, unless every size and number is in its range: no box is empty.
[[nodiscard]] Result<MainThings> main_things_of(std::span<const std::byte> bytes);

}  // namespace touchline
