// The network that tells the main thing of a photograph from the rest, as an ONNX file.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/network/trained_network.h"

namespace touchline {

/// Its input is 1 x 3 x height x width, planes red, green, blue, each value (v - 128) / 256, of any
/// size whose sides are multiples of 64; its output is 1 x 1 x height x width, 0 to 1. Source:
/// IS-Net (Qin et al. 2022), which stretches the picture to a square.
class FigureNetwork {
  public:
    /// Fails with one line if OpenCV cannot build it.
    [[nodiscard]] static Result<FigureNetwork> from_onnx(std::span<const std::byte> model);

    /// Returns how likely each place of an 8-bit BGR picture belongs to its main thing, 0..1, over
    /// a square of side_px (a multiple of 64) for the whole picture. Fails, with one line, if the
    /// network is of another kind or cannot be run; throws std::bad_alloc without memory. 0.7 s at
    /// 512 and 3.3 s at 1024 on two cores.
    [[nodiscard]] Result<cv::Mat1f> likelihood(const cv::Mat3b& picture, int side_px);

  private:
    explicit FigureNetwork(TrainedNetwork network) : network_(std::move(network)) {}

    TrainedNetwork network_;
};

}  // namespace touchline
