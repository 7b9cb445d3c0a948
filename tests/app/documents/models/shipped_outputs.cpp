#include "tests/app/documents/models/shipped_outputs.h"

#include "app/documents/models/networks.h"
#include "vision/figure/small_figure_network.h"
#include "vision/network/trained_network.h"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <opencv2/core.hpp>

namespace touchline::testing {
namespace {

template <class T>
T value_of(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().line);
    return std::move(*result);
}

using Colour = std::array<double, 3>;  // 0 ... 255, in the network's own order of planes

struct Oval {
    double x, y, half_width, half_height;
    Colour colour;
};

struct Drawing {
    std::string_view name;
    std::vector<Oval> ovals;  // in shares of the picture's side, later ones in front
};

constexpr Colour skin{205, 160, 135};
constexpr Colour dark{45, 32, 30};
constexpr Colour white{240, 238, 235};
constexpr Colour lips{165, 75, 75};
constexpr Colour coat{40, 60, 120};

std::vector<Drawing> drawings() {
    return {{"shapes",
             {{0.3, 0.3, 0.2, 0.2, {200, 40, 40}},
              {0.7, 0.65, 0.22, 0.12, {40, 180, 60}},
              {0.25, 0.75, 0.08, 0.2, {30, 60, 210}}}},
            {"face",
             {{0.5, 0.43, 0.36, 0.41, dark},
              {0.5, 0.52, 0.3, 0.38, skin},
              {0.38, 0.46, 0.065, 0.03, white},
              {0.62, 0.46, 0.065, 0.03, white},
              {0.38, 0.46, 0.028, 0.03, dark},
              {0.62, 0.46, 0.028, 0.03, dark},
              {0.38, 0.38, 0.09, 0.014, dark},
              {0.62, 0.38, 0.09, 0.014, dark},
              {0.47, 0.63, 0.014, 0.01, dark},
              {0.53, 0.63, 0.014, 0.01, dark},
              {0.5, 0.74, 0.1, 0.028, lips}}},
            {"person",
             {{0.5, 1.0, 0.4, 0.42, coat},
              {0.5, 0.55, 0.08, 0.14, skin},
              {0.5, 0.3, 0.16, 0.19, dark},
              {0.5, 0.34, 0.13, 0.17, skin},
              {0.45, 0.32, 0.025, 0.012, dark},
              {0.55, 0.32, 0.025, 0.012, dark},
              {0.5, 0.44, 0.045, 0.012, lips}}}};
}

/// Returns the colour at a place, over a ground that grows lighter downwards and to the right.
Colour colour_at(const Drawing& drawing, double x, double y) {
    Colour colour{90 + 60 * x, 110 + 70 * y, 120 + 40 * x * y};
    for (const Oval& oval : drawing.ovals) {
        const double across = (x - oval.x) / oval.half_width;
        const double down = (y - oval.y) / oval.half_height;
        if (across * across + down * down <= 1) colour = oval.colour;
    }
    return colour;
}

struct Shipped {
    std::string_view name;
    int side_px;
    double middle;  // value of 0 ... 255 that becomes 0
    double one;     // step of 0 ... 255 that becomes 1
    std::vector<std::vector<int>> outputs;
};

std::vector<Shipped> shipped() {
    return {
        {"nanodet",
         416,
         116,
         57,
         {{1, 2704, 80}, {1, 676, 80}, {1, 169, 80}, {1, 2704, 44}, {1, 676, 44}, {1, 169, 44}}},
        {"blazeface", 256, 127.5, 127.5, {{1, 512, 1}, {1, 384, 1}, {1, 512, 16}, {1, 384, 16}}},
        {"facemesh", 192, 0, 255, {{1, 1404}, {1, 266}, {1, 1}}},
        {"selfie", 256, 0, 255, {{1, 256, 256, 1}}}};
}

/// The small network of the figure sees what is computed of a picture, too.
cv::Mat1f small_figure_of(const Drawing& drawing, SmallFigureNetwork& network) {
    constexpr int side_px = 256;
    cv::Mat3b picture(side_px, side_px);
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x) {
            const Colour rgb = colour_at(drawing, (x + 0.5) / side_px, (y + 0.5) / side_px);
            picture(y, x) =
                cv::Vec3b(cv::saturate_cast<uchar>(rgb[2]), cv::saturate_cast<uchar>(rgb[1]),
                          cv::saturate_cast<uchar>(rgb[0]));
        }
    return value_of(network.likelihood(picture));
}

cv::Mat input_of(const Drawing& drawing, const Shipped& network) {
    const int side_px = network.side_px;
    cv::Mat input(std::vector<int>{1, 3, side_px, side_px}, CV_32F);
    for (int y = 0; y < side_px; ++y)
        for (int x = 0; x < side_px; ++x) {
            const Colour colour = colour_at(drawing, (x + 0.5) / side_px, (y + 0.5) / side_px);
            for (int plane = 0; plane < 3; ++plane)
                input.ptr<float>(0, plane, y)[x] = static_cast<float>(
                    (colour.at(static_cast<std::size_t>(plane)) - network.middle) / network.one);
        }
    return input;
}

std::string text_of(const std::vector<int>& shape) {
    std::string text;
    for (const int size : shape) text += (text.empty() ? "" : "x") + std::to_string(size);
    return text;
}

/// The matrix must be contiguous, as a network's answer is.
std::vector<double> numbers_of(const cv::Mat1f& output) {
    constexpr std::size_t places = 16;
    std::vector<double> numbers{cv::norm(output, cv::NORM_INF), cv::mean(output)[0]};
    const std::size_t last = output.total() - 1;
    for (std::size_t i = 0; i < places; ++i)
        numbers.push_back(output.ptr<float>()[last * i / (places - 1)]);
    return numbers;
}

}  // namespace

std::vector<OutputRow> shipped_outputs() {
    cv::setNumThreads(1);
    std::vector<OutputRow> rows;
    for (const Shipped& network : shipped()) {
        const auto bytes = value_of(read_network(*network_named(network.name)));
        auto trained = value_of(TrainedNetwork::from_onnx(bytes, "is tried"));
        for (const Drawing& drawing : drawings()) {
            const auto outputs =
                value_of(trained.outputs(input_of(drawing, network), network.outputs));
            for (std::size_t i = 0; i < outputs.size(); ++i)
                rows.push_back({std::string(network.name) + "," + std::string(drawing.name) + "," +
                                    text_of(network.outputs[i]),
                                numbers_of(outputs[i])});
        }
    }
    auto small = value_of(
        SmallFigureNetwork::from_onnx(value_of(read_network(*network_named("small-figure")))));
    for (const Drawing& drawing : drawings())
        rows.push_back({"small-figure," + std::string(drawing.name) + ",128x128",
                        numbers_of(small_figure_of(drawing, small))});
    return rows;
}

}  // namespace touchline::testing
