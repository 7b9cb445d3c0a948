// Computes a colour gradient from pixels: the working picture, its noise, and where and how steeply
// colours change.
// Threads: pure functions. All are O(pixels).
#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// Lab colours in units of grey levels: L is stretched to 0..255, a and b are CIE units times a
/// weight. A step of one grey level is a step of about one unit.
using LabPicture = cv::Mat3f;

/// The weight at which a difference of colour counts as much as one of lightness that looks as
/// large. At 1, colour counts less, and so do JPEG's colour errors.
inline constexpr float full_colour = 2.55F;

/// Returns the picture reduced to at most `max_pixels` by area averaging (never enlarged), 8-bit,
/// BGR or grey as it came.
[[nodiscard]] cv::Mat reduced(const cv::Mat& picture, double max_pixels);

[[nodiscard]] LabPicture to_lab(const cv::Mat& bgr_or_grey, float colour_weight = 1.0F);

/// Returns the standard deviation of the picture's white noise in grey levels, all channels
/// together. Uses the |second differences both ways| (Immerkaer 1996, by their lower quartile, so
/// that edges do not count).
[[nodiscard]] double noise_of(const LabPicture& lab);

/// Below this noise, the picture did not come from a camera.
inline constexpr double no_grain = 0.5;

/// Returns what white noise of this size leaves in the gradient after Gaussian smoothing (one
/// component, standard deviation): noise / (sqrt(8 pi) sigma^2).
[[nodiscard]] double gradient_noise(double noise, double sigma_px);

/// strength: greatest rate of colour change, grey levels per pixel. normal: unit vector of that
/// change, towards where the sum of the channels grows (lighter, else redder and yellower). Both
/// are at pixel centres.
struct GradientField {
    cv::Mat1f strength;
    cv::Mat2f normal;
    bool has_light_side = true;  // false: the normal's sign means nothing
};

/// Returns the unit eigenvector of the larger eigenvalue of the symmetric matrix (xx xy; xy yy), x
/// >= 0; (1, 0) if the eigenvalues are equal.
[[nodiscard]] cv::Vec2f major_axis(float xx, float yy, float xy);

/// Applies Gaussian smoothing, then the structure tensor of the three channels (Di Zenzo 1986).
[[nodiscard]] GradientField colour_gradient(const LabPicture& lab, double sigma_px);

/// Returns the value below which this fraction (0..1) of some values lies, of which there is one.
/// O(values).
template <class T>
[[nodiscard]] T quantile(std::vector<T> values, double fraction) {
    const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + at);
    return *(values.begin() + at);
}

/// Returns the middle one of some values, of which there is one; the upper of two. O(values).
template <class T>
[[nodiscard]] T median_of(std::vector<T> values) {
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The same fraction of a picture's elements, from a sample of at most about 250 000; 0 of none.
[[nodiscard]] float quantile(const cv::Mat1f& values, double fraction);

}  // namespace touchline
