#include "vision/contour/scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

constexpr double kFinest_px = 1.0;  // below it, the pixel grid shows in the slopes
constexpr double kPhoto_px = 2.5;   // best of 1, 1.4, 2, 2.5, 2.8, 4 on photos
constexpr double kDrawing = 0.20;   // at most this part of the picture changes: a drawing
constexpr double kPhoto = 0.40;     // at least this part: a photo
constexpr double kRounding = 0.3;   // gradient that 8-bit rounding and compression leave, per pixel
constexpr double kSignificance = 6.0;       // x gradient noise: 2e-8 of the pixels of pure noise
constexpr double kMedianOverSigma = 1.177;  // of a Rayleigh distribution: the gradient of noise
constexpr double kMostlyNoise = 2.5;  // measured over predicted gradient noise; photos 5 and more
constexpr double kHighOverQuantile = 3.0;  // binds in drawings, which have only strong edges
constexpr double kGrainOverQuantile = 2.0;
constexpr double kHighOverStrongest = 0.45;  // F .613 on photos; .609 at 0.5, .606 at 0.6
constexpr double kLowOverHigh = 0.4;

/// Returns the share of the pixels whose lightness differs across them by more than noise and
/// rounding explain. Unsmoothed, because close lines of a drawing leave flat pixels between them,
/// and the texture of a photo does not.
double changing_part(const LabPicture& lab, double noise) {
    const double limit = std::max(2.0 * kRounding, 3.0 * noise / std::numbers::sqrt2);
    const auto limit_squared = static_cast<float>(4.0 * limit * limit);
    std::size_t changing = 0;
    for (int y = 1; y + 1 < lab.rows; ++y) {
        for (int x = 1; x + 1 < lab.cols; ++x) {
            const float dx = lab(y, x + 1)[0] - lab(y, x - 1)[0];
            const float dy = lab(y + 1, x)[0] - lab(y - 1, x)[0];
            changing += dx * dx + dy * dy > limit_squared ? 1 : 0;
        }
    }
    return static_cast<double>(changing) / static_cast<double>(lab.total());
}

double quantile_of(const GradientField& field, double fraction) {
    return static_cast<double>(quantile(field.strength, fraction));
}

Hysteresis hysteresis(double high) {
    return {kLowOverHigh * high, high};
}

}  // namespace

double smoothing_for(const LabPicture& lab, double noise) {
    // The smallest sigma that brings the gradient's noise down to one grey level a pixel.
    const double fine_px = std::clamp(kFinest_px * std::sqrt(gradient_noise(noise, kFinest_px)),
                                      kFinest_px, kPhoto_px);
    const double part = changing_part(lab, noise);
    const double photo = std::clamp((part - kDrawing) / (kPhoto - kDrawing), 0.0, 1.0);
    return fine_px + photo * (kPhoto_px - fine_px);
}

Hysteresis thresholds_for(const GradientField& field, double noise, double sigma_px) {
    const double median = quantile_of(field, 0.5);
    const double predicted = gradient_noise(noise, sigma_px);
    const double measured = median / kMedianOverSigma;
    // If most of the gradient is noise, the gradient itself measures it best.
    const double floor =
        kSignificance *
        (measured < kMostlyNoise * predicted ? std::max(predicted, measured) : predicted);
    const double crowd = std::min(kHighOverQuantile * quantile_of(field, 0.75),
                                  kHighOverStrongest * quantile_of(field, 0.98));
    return hysteresis(std::max({crowd, floor, 4.0 * kRounding}));
}

Hysteresis grain_thresholds(const GradientField& field) {
    return hysteresis(std::max(kGrainOverQuantile * quantile_of(field, 0.75), 4.0 * kRounding));
}

}  // namespace touchline
