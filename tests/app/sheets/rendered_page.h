// A page as ink: what a printer would put on paper, judged pixel by pixel.
// Threads: one.
#pragma once

#include "app/sheets/tactile_sheet.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// 255 where there is black ink; the blue of the print is none.
struct InkPage {
    cv::Mat1b ink;
    double px_per_mm = 0.0;

    [[nodiscard]] cv::Point pixel(PaperPoint p) const;
    [[nodiscard]] cv::Rect pixels(const PaperBox& box) const;
};

/// Page `index` of a PDF. Throws if it cannot be read.
[[nodiscard]] InkPage rendered(std::span<const std::byte> pdf, int index, double dpi);

/// Pages of a PDF, and its first page's size in millimetres.
[[nodiscard]] int page_count(std::span<const std::byte> pdf);
[[nodiscard]] PaperSize page_size(std::span<const std::byte> pdf);

/// The least distance between two pieces of ink that are not joined, in millimetres; infinite for
/// one piece.
[[nodiscard]] double least_gap_mm(const InkPage& page);

/// The middles of all pieces of ink as large as a dot of braille.
[[nodiscard]] std::vector<PaperPoint> dots_on(const InkPage& page);

/// The cells of a row, read from the dots that are found; `used` counts each dot that was read.
[[nodiscard]] std::vector<std::uint8_t> read_row(const std::vector<PaperPoint>& dots,
                                                 PaperPoint first_dot, std::size_t cells,
                                                 std::vector<int>& used);

/// By liblouis, with its own tables, backwards. Throws if it fails.
[[nodiscard]] std::string back_translated(const std::vector<std::uint8_t>& cells,
                                          const std::string& table);

}  // namespace touchline
