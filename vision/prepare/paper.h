// The colour of the paper, however uneven the light on it, and the ink that stands out from it,
// whatever the colours.
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
    static constexpr int term_count = 6;
    using Terms = cv::Vec<double, term_count>;  // 1, x, y, x x, x y, y y; x and y run from -1 to 1

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

/// Returns a colour for a pixel that is surely not paper, even if it is more even than the paper
/// is: far from all others and from those of other such pixels, so that no surface goes through it.
[[nodiscard]] inline cv::Vec3f no_paper(int x, int y) {
    return cv::Vec3f::all(-1000.0F * static_cast<float>(1 + (7 * y + x) % 97));
}

/// Returns the picture as it would be if the paper had the same colour everywhere as in its middle:
/// light divided out, colours kept. Returns it unchanged if the paper has no light in the middle.
/// O(pixels).
[[nodiscard]] LabPicture evenly_lit(const LabPicture& lab, const Paper& paper);

/// Returns the picture with each pixel of the mask in the colour of the nearest one outside.
/// O(pixels).
[[nodiscard]] cv::Mat3f painted_over(const cv::Mat3f& picture, const cv::Mat1b& mask);

struct Ink {
    /// The difference of each pixel's colour from that of the paper there, grey levels.
    cv::Mat1f contrast;
    /// contrast over the contrast half-way to the ink around it: the edge of a stroke is the line
    /// where this is 1, even beside a darker stroke. Less than 1 everywhere if nothing stands out.
    cv::Mat1f darkness;
    /// darkness >= 1: 255, else 0.
    cv::Mat1b mask;
    /// A contrast below this is paper, grey levels.
    double floor = 0.0;
    /// The part of the picture in which the paper's colour is the commonest, by places: 0..1.
    double paper_part = 0.0;
};

/// Returns the least contrast of ink for the strongest one, grey levels: above grain, and above
/// dirt and shadow, which are faint beside ink.
[[nodiscard]] double least_contrast(double noise, double strongest);

/// Takes as paper the colour that most places share, which may change slowly across the picture (a
/// second-order surface, so a lamp's shade does no harm and no filled shape, however large, is
/// mistaken for shade). Paper may be dark: ink is what differs. Deterministic. O(pixels), about 25
/// ms a megapixel.
[[nodiscard]] Ink ink_of(const LabPicture& lab, double noise);

}  // namespace touchline
