#include "tests/lab/bench/vision/detectors.h"

#if TOUCHLINE_HAS_XIMGPROC

#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_drawing.hpp>

namespace touchline::bench {
namespace {

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

}  // namespace

void add_edge_drawing(std::vector<Detector>& all) {
    for (const bool is_parameter_free : {false, true}) {
        all.push_back(of_rule("EdgeDrawing", is_parameter_free ? "EDPF" : "ED; σ 1.5 px",
                              [=](const cv::Mat& picture, double multiple) {
                                  return edge_drawing(picture, is_parameter_free, multiple);
                              }));
    }
}

}  // namespace touchline::bench

#else

namespace touchline::bench {

void add_edge_drawing(std::vector<Detector>&) {}

}  // namespace touchline::bench

#endif
