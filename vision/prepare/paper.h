// Finds the colour of the paper, however uneven the light on it.
// Threads: pure functions.
#pragma once

#include "vision/contour/gradient.h"

#include <array>
#include <vector>

namespace touchline {

/// The commonest colour of a picture as a function of the place: a second-order surface in each
/// channel, so that a lamp's shade does no harm and no filled shape, however large, is mistaken for
/// shade. It may be dark.
class Paper {
  public:
    static constexpr int kTerms = 6;
    using Terms = cv::Vec<double, kTerms>;  // 1, x, y, x x, x y, y y; x and y run from -1 to 1

    /// Fits the surface that most places (20 x 20, each the median of 49 pixels) agree with; an
    /// even one if that surface misses a colour that extends over the whole picture. Deterministic.
    /// O(1) in the pixels: about 3 ms.
    explicit Paper(const LabPicture& lab);

    /// The part of the places that agree: 0..1.
    [[nodiscard]] double part() const { return part_; }

    /// Fills in its colours along a row of the picture it was made from.
    void fill_row(int row, std::vector<cv::Vec3f>& colours) const;

  private:
    std::array<Terms, 3> weights_{};  // by channel
    cv::Size size_;
    double part_ = 0.0;
};

/// Returns the picture as it would be if the paper had the same colour everywhere as in its middle:
/// light divided out, colours kept. Returns it unchanged if the paper has no light in the middle.
/// O(pixels).
[[nodiscard]] LabPicture evenly_lit(const LabPicture& lab, const Paper& paper);

}  // namespace touchline
