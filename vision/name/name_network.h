// The network that finds things of 80 kinds in a picture, as an ONNX file, and its answer as things
// in boxes.
// Threads: pure functions; one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "config/types/thing_name.h"
#include "vision/network/trained_network.h"

#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// The side of the square that the network looks at, in pixels.
inline constexpr int names_side_px = 416;

/// The number of kinds of things it knows, and of the steps into which it divides a distance.
inline constexpr int known_kinds = 80;
inline constexpr int distance_steps = 11;

/// Its answer on a grid of side x side cells over that square: a row for each cell, row by row.
struct GridAnswer {
    int side = 0;
    cv::Mat1f likelihoods;  // known_kinds columns, 0..1: the middle of such a thing is here
    cv::Mat1f distances;    // 4 x distance_steps columns: how likely its left, upper, right, lower
                            // side is k cells from the cell's middle, as logits; all finite
};

/// Where the picture lies in that square, in pixels; the rest is black.
struct Letterbox {
    cv::Rect part;
};

/// Places the whole picture, as large as fits, in the middle.
[[nodiscard]] Letterbox letterbox_of(cv::Size picture);

struct Detection {
    int kind = 0;             // by COCO's order, 0 a person
    double likelihood = 0.0;  // from detected_from on
    ThingBox box;             // sound
};

/// Less likely ones are left out.
inline constexpr double detected_from = 0.35;

/// Returns the mean of the answers about the square and about its mirror image.
[[nodiscard]] GridAnswer mean_of(const GridAnswer& upright, const GridAnswer& mirrored);

/// A cell stands for its likeliest kind, with the mean distances as a box, as far as it lies in the
/// picture. The likeliest box stays among boxes of one kind that overlap by more than a half, and
/// among any that overlap by more than 0.7. The likeliest come first. O(cells squared) at worst:
/// 3549 cells take 60 ms. Source: Li et al. 2020 (generalized focal loss); RangiLyu's NanoDet.
[[nodiscard]] std::vector<Detection> detections_of(std::span<const GridAnswer> answers,
                                                   const Letterbox& letterbox);

/// Its input is 1 x 3 x 416 x 416, planes blue, green, red about their means. Its output has what
/// GridAnswer holds, for grids of 52, 26 and 13 cells a side. Source: NanoDet-g (RangiLyu).
class NameNetwork {
  public:
    /// Fails with one line if OpenCV cannot build it.
    [[nodiscard]] static Result<NameNetwork> from_onnx(std::span<const std::byte> model);

    /// Returns the things in a non-empty 8-bit BGR picture, by the mean of it and its mirror image,
    /// or by it alone. Fails, with one line, if the network is of another kind or cannot be run;
    /// throws std::bad_alloc without memory. 0.1 s a look on one core.
    [[nodiscard]] Result<std::vector<Detection>> detections(const cv::Mat3b& picture,
                                                            bool with_mirror_image = true);

  private:
    explicit NameNetwork(TrainedNetwork network) : network_(std::move(network)) {}

    Result<std::vector<GridAnswer>> answers(const cv::Mat3b& square);

    TrainedNetwork network_;
};

}  // namespace touchline
