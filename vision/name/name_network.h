// The network that finds things of 80 kinds in a picture, as an ONNX file.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/name/detections.h"
#include "vision/network/trained_network.h"

namespace touchline {

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
