#include "tests/lab/bench/vision/detectors.h"

#include "vision/contour/edge_lines.h"
#include "vision/contour/photo_lines.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

#if TOUCHLINE_HAS_XIMGPROC
#include <opencv2/ximgproc/edge_drawing.hpp>
#endif

namespace touchline::bench {
namespace {

constexpr double shown_side_mm = 116.0;  // the longer side, on the drawing area

uchar strength_of(double multiple) {
    return cv::saturate_cast<uchar>(255.0 * multiple / (1.0 + multiple) + 0.5);
}

using Rule = std::function<cv::Mat1b(const cv::Mat& picture, double multiple)>;

/// Makes both functions of a detector from a rule with a multiple of its threshold.
Detector of_rule(std::string name, std::string setting, const Rule& rule) {
    return {std::move(name), std::move(setting),
            [rule](const cv::Mat& picture) { return rule(picture, 1.0); },
            [rule](const cv::Mat& picture) {
                cv::Mat1b strength(picture.size(), uchar{0});
                for (const double multiple : {0.4, 0.5, 0.6, 0.7, 0.85, 1.0, 1.2, 1.5, 1.9, 2.5}) {
                    strength.setTo(strength_of(multiple), rule(picture, multiple));
                }
                return strength;
            }};
}

/// The popular rule: thresholds a third below and above the median grey level.
cv::Mat1b grey_canny(const cv::Mat& picture, double multiple) {
    cv::Mat grey;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    cv::GaussianBlur(grey, grey, {}, 1.4);
    cv::Mat1f values;
    grey.convertTo(values, CV_32F);
    const double median = static_cast<double>(quantile(values, 0.5));
    cv::Mat1b edges;
    cv::Canny(grey, edges, 0.67 * median * multiple, 1.33 * median * multiple, 3, true);
    return edges;
}

/// Slopes of the Lab channel that changes most at each pixel, in 64ths of a grey level a pixel.
struct Slopes {
    cv::Mat1s dx;
    cv::Mat1s dy;
    cv::Mat1f size;
};

Slopes lab_slopes(const cv::Mat& picture, double sigma_px) {
    LabPicture lab = to_lab(picture);
    cv::GaussianBlur(lab, lab, {}, sigma_px);
    cv::Mat3f dx;
    cv::Mat3f dy;
    cv::Sobel(lab, dx, CV_32F, 1, 0, 1, 0.5 * 64.0);
    cv::Sobel(lab, dy, CV_32F, 0, 1, 1, 0.5 * 64.0);
    Slopes slopes{cv::Mat1s(lab.size()), cv::Mat1s(lab.size()), cv::Mat1f(lab.size())};
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            int steepest = 0;
            std::array<float, 3> size{};
            for (int c = 0; c < 3; ++c) {
                size.at(static_cast<std::size_t>(c)) = std::hypot(dx(y, x)[c], dy(y, x)[c]);
                if (size.at(static_cast<std::size_t>(c)) >
                    size.at(static_cast<std::size_t>(steepest))) {
                    steepest = c;
                }
            }
            slopes.dx(y, x) = cv::saturate_cast<short>(dx(y, x)[steepest]);
            slopes.dy(y, x) = cv::saturate_cast<short>(dy(y, x)[steepest]);
            slopes.size(y, x) = size.at(static_cast<std::size_t>(steepest));
        }
    }
    return slopes;
}

cv::Mat1b lab_canny(const Slopes& slopes, double high) {
    cv::Mat1b edges;
    cv::Canny(slopes.dx, slopes.dy, edges, 0.4 * high, high, true);
    return edges;
}

Detector lab_median(double sigma_px, double times) {
    return of_rule("Canny on Lab", fmt::format("σ {} px; {} × median", sigma_px, times),
                   [=](const cv::Mat& picture, double multiple) {
                       const Slopes slopes = lab_slopes(picture, sigma_px);
                       const double median = static_cast<double>(quantile(slopes.size, 0.5));
                       return lab_canny(slopes, multiple * times * median);
                   });
}

Detector lab_quantile(double sigma_px, double fraction) {
    return of_rule("Canny on Lab", fmt::format("σ {} px; {} %", sigma_px, 100.0 * fraction),
                   [=](const cv::Mat& picture, double multiple) {
                       const Slopes slopes = lab_slopes(picture, sigma_px);
                       const auto high = static_cast<double>(quantile(slopes.size, fraction));
                       return lab_canny(slopes, multiple * high);
                   });
}

/// Our edges, stage by stage; with sigma 0 the picture sets it.
Detector ours(const std::string& setting, double sigma_px, float colour_weight) {
    const auto find = [=](const cv::Mat& picture) -> cv::Mat1b {
        const LabPicture lab = to_lab(picture, colour_weight);
        const double noise = noise_of(lab);
        const double sigma = sigma_px > 0.0 ? sigma_px : smoothing_for(lab, noise);
        const GradientField field = colour_gradient(lab, sigma);
        const Hysteresis limits = thresholds_for(field, noise, sigma);
        return edge_strength(edge_lines(field, limits), lab.size(), limits.high);
    };
    return {"Touchline edges", setting, find, find};
}

/// Our lines at a part of the size, with the map enlarged again.
Detector reduced_by(double factor) {
    const auto find = [=](const cv::Mat& picture) -> cv::Mat1b {
        cv::Mat small;
        cv::resize(picture, small, {}, factor, factor, cv::INTER_AREA);
        const cv::Mat strength = photo_lines(small, shown_side_mm).edge_strength;
        cv::Mat1b large;
        cv::resize(strength, large, picture.size(), 0.0, 0.0, cv::INTER_NEAREST);
        return large;
    };
    return {"Touchline lines", fmt::format("at {} of the width", factor), find, find};
}

/// All of photo_lines.
Detector whole() {
    const auto find = [](const cv::Mat& picture) -> cv::Mat1b {
        return photo_lines(picture, shown_side_mm).edge_strength;
    };
    return {"Touchline lines", "as built", find, find};
}

#if TOUCHLINE_HAS_XIMGPROC
/// Topal and Akinlar 2012; with `is_parameter_free` its chains are validated (EDPF).
cv::Mat1b edge_drawing(const cv::Mat& picture, bool is_parameter_free, double multiple) {
    cv::Mat grey;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    const auto drawing = cv::ximgproc::createEdgeDrawing();
    cv::ximgproc::EdgeDrawing::Params settings;
    settings.PFmode = is_parameter_free;
    settings.EdgeDetectionOperator = cv::ximgproc::EdgeDrawing::SOBEL;
    settings.GradientThresholdValue = static_cast<int>(36.0 * multiple);
    settings.MinPathLength = 15;
    settings.Sigma = 1.5F;
    drawing->setParams(settings);
    drawing->detectEdges(grey);
    cv::Mat edges;
    drawing->getEdgeImage(edges);
    return edges;
}

/// Adds OpenCV's EdgeDrawing if its ximgproc is installed.
void add_edge_drawing(std::vector<Detector>& all) {
    for (const bool is_parameter_free : {false, true}) {
        all.push_back(of_rule("EdgeDrawing", is_parameter_free ? "EDPF" : "ED; σ 1.5 px",
                              [=](const cv::Mat& picture, double multiple) {
                                  return edge_drawing(picture, is_parameter_free, multiple);
                              }));
    }
}
#else
void add_edge_drawing(std::vector<Detector>& /*all*/) {}
#endif

}  // namespace

std::vector<Detector> detectors() {
    std::vector<Detector> all{of_rule("Canny on grey", "median ± 33 %", grey_canny),
                              lab_quantile(2.5, 0.9), lab_quantile(2.5, 0.95), lab_median(2.0, 4.0),
                              lab_median(2.5, 4.0)};
    add_edge_drawing(all);
    all.push_back(ours("as built", 0.0, full_colour));
    all.push_back(ours("colour counts less", 0.0, 1.0F));
    for (const double sigma_px : {1.0, 1.5, 3.5}) {
        all.push_back(ours(fmt::format("σ {} px", sigma_px), sigma_px, full_colour));
    }
    all.push_back(whole());
    all.push_back(reduced_by(0.7));
    all.push_back(reduced_by(0.5));
    return all;
}

}  // namespace touchline::bench
