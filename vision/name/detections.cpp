#include "vision/name/detections.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace touchline {
namespace {

constexpr double kSameThing = 0.5;
constexpr double kSamePlace = 0.7;

/// The columns of `distances` of the left, upper, right and lower side, seen in a mirror.
constexpr std::array kMirroredSides{2, 1, 0, 3};

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
    return overlap_of(a.box, b.box) > (a.kind == b.kind ? kSameThing : kSamePlace);
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
            const int side = kMirroredSides[static_cast<std::size_t>(column / distance_steps)];
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

}  // namespace touchline
