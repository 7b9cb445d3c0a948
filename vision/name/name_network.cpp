#include "vision/name/name_network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <opencv2/dnn.hpp>

namespace touchline {
namespace {

constexpr double same_thing = 0.5;
constexpr double same_place = 0.7;

/// The columns of `distances` of the left, upper, right and lower side, seen in a mirror.
constexpr std::array mirrored_sides{2, 1, 0, 3};

/// Returns the mean of the steps by their softmax, in cells.
double distance_of(const float* logits) {
    const double greatest = *std::max_element(logits, logits + distance_steps);
    double sum = 0.0;
    double weighted = 0.0;
    for (int step = 0; step < distance_steps; ++step) {
        const double weight = std::exp(static_cast<double>(logits[step]) - greatest);
        sum += weight;
        weighted += weight * step;
    }
    return weighted / sum;
}

ThingBox box_of(const GridAnswer& answer, int cell, const Letterbox& letterbox) {
    const double cell_px = static_cast<double>(names_side_px) / answer.side;
    std::array<double, 4> from_middle_px{};
    for (int side = 0; side < 4; ++side) {
        const float* logits = answer.distances[cell] + std::ptrdiff_t{side} * distance_steps;
        from_middle_px[static_cast<std::size_t>(side)] = distance_of(logits) * cell_px;
    }
    const cv::Rect& part = letterbox.part;
    const double x_px = (cell % answer.side + 0.5) * cell_px - part.x;
    const double y_px = (cell / answer.side + 0.5) * cell_px - part.y;
    const auto share = [](double px, int of_px) { return std::clamp(px / of_px, 0.0, 1.0); };
    return {
        share(x_px - from_middle_px[0], part.width), share(y_px - from_middle_px[1], part.height),
        share(x_px + from_middle_px[2], part.width), share(y_px + from_middle_px[3], part.height)};
}

void add_detections(const GridAnswer& answer, const Letterbox& letterbox,
                    std::vector<Detection>& found) {
    for (int cell = 0; cell < answer.likelihoods.rows; ++cell) {
        const float* likelihoods = answer.likelihoods[cell];
        const float* at = std::max_element(likelihoods, likelihoods + known_kinds);
        const double likelihood = *at;
        if (!(likelihood >= detected_from)) continue;  // also if NaN
        const ThingBox box = box_of(answer, cell, letterbox);
        if (is_sound(box))
            found.push_back({static_cast<int>(at - likelihoods), std::min(1.0, likelihood), box});
    }
}

bool are_one(const Detection& a, const Detection& b) {
    return overlap_of(a.box, b.box) > (a.kind == b.kind ? same_thing : same_place);
}

constexpr std::array grid_sides{52, 26, 13};

cv::Mat3b in_square(const cv::Mat3b& picture, const Letterbox& letterbox) {
    cv::Mat3b square(names_side_px, names_side_px, cv::Vec3b(0, 0, 0));
    stretched(picture, letterbox.part.size()).copyTo(square(letterbox.part));
    return square;
}

/// Uses the means and deviations of the pictures that it was trained on: blue, green, red.
cv::Mat input_of(const cv::Mat3b& square) {
    cv::Mat3f values;
    square.convertTo(values, CV_32F);
    cv::subtract(values, cv::Scalar(103.53, 116.28, 123.675), values);
    cv::divide(values, cv::Scalar(57.375, 57.12, 58.395), values);
    return cv::dnn::blobFromImage(values);
}

std::vector<std::vector<int>> shapes() {
    std::vector<std::vector<int>> shapes;
    for (const int side : grid_sides) {
        shapes.push_back({1, side * side, known_kinds});
        shapes.push_back({1, side * side, 4 * distance_steps});
    }
    return shapes;
}

}  // namespace

Letterbox letterbox_of(cv::Size picture) {
    const double scale =
        static_cast<double>(names_side_px) / std::max(picture.width, picture.height);
    const int width_px = std::max(1, cvRound(picture.width * scale));
    const int height_px = std::max(1, cvRound(picture.height * scale));
    return {{(names_side_px - width_px) / 2, (names_side_px - height_px) / 2, width_px, height_px}};
}

GridAnswer mean_of(const GridAnswer& upright, const GridAnswer& mirrored) {
    GridAnswer mean{upright.side, upright.likelihoods.clone(), upright.distances.clone()};
    for (int cell = 0; cell < mean.likelihoods.rows; ++cell) {
        const int opposite = cell - cell % mean.side + mean.side - 1 - cell % mean.side;
        for (int kind = 0; kind < known_kinds; ++kind) {
            float& value = mean.likelihoods(cell, kind);
            value = 0.5F * value + 0.5F * mirrored.likelihoods(opposite, kind);
        }
        for (int column = 0; column < 4 * distance_steps; ++column) {
            const int side = mirrored_sides[static_cast<std::size_t>(column / distance_steps)];
            float& value = mean.distances(cell, column);
            value = 0.5F * value + 0.5F * mirrored.distances(opposite, side * distance_steps +
                                                                           column % distance_steps);
        }
    }
    return mean;
}

std::vector<Detection> detections_of(std::span<const GridAnswer> answers,
                                     const Letterbox& letterbox) {
    std::vector<Detection> found;
    for (const GridAnswer& answer : answers) add_detections(answer, letterbox, found);
    std::ranges::stable_sort(found, std::ranges::greater{}, &Detection::likelihood);
    std::vector<Detection> kept;
    for (const Detection& detection : found) {
        const bool is_new = std::ranges::none_of(
            kept, [&detection](const Detection& other) { return are_one(detection, other); });
        if (is_new) kept.push_back(detection);
    }
    return kept;
}

Result<NameNetwork> NameNetwork::from_onnx(std::span<const std::byte> model) {
    return TrainedNetwork::from_onnx(model, "names things").map([](TrainedNetwork&& network) {
        return NameNetwork(std::move(network));
    });
}

Result<std::vector<GridAnswer>> NameNetwork::answers(const cv::Mat3b& square) {
    const auto found = network_.outputs(input_of(square), shapes());
    if (!found) return tl::unexpected(found.error());
    std::vector<GridAnswer> answers;
    for (std::size_t i = 0; i < grid_sides.size(); ++i) {
        const GridAnswer answer{grid_sides[i], (*found)[2 * i], (*found)[2 * i + 1]};
        if (!are_likelihoods(answer.likelihoods))
            return network_.unusable("its output is no likelihood");
        answers.push_back(answer);
    }
    return answers;
}

Result<std::vector<Detection>> NameNetwork::detections(const cv::Mat3b& picture,
                                                       bool with_mirror_image) {
    const Letterbox letterbox = letterbox_of(picture.size());
    const cv::Mat3b square = in_square(picture, letterbox);
    auto upright = answers(square);
    if (!upright || !with_mirror_image)
        return upright.map([&letterbox](const auto& all) { return detections_of(all, letterbox); });
    cv::Mat3b mirror_image;
    cv::flip(square, mirror_image, 1);
    const auto mirrored = answers(mirror_image);
    if (!mirrored) return tl::unexpected(mirrored.error());
    std::ranges::transform(*upright, *mirrored, upright->begin(), mean_of);
    return detections_of(*upright, letterbox);
}

}  // namespace touchline
