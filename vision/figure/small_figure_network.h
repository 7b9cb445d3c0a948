// The small network that tells the main thing of a photograph from the rest: trained here, from
// free pictures (tests/lab/figure_network), so it ships. Threads: one object, one thread at a time
// (OpenCV uses its own inside).
#pragma once

#include "vision/network/trained_network.h"

namespace touchline {

/// Its input is 1 x 9 x 256 x 256: planes red, green, blue, each value (v - 128) / 128, and the
/// cues of vision/figure/figure_cues.h. Its output is 1 x 1 x 128 x 128, 0 to 1.
class SmallFigureNetwork {
  public:
    /// Fails with one line if OpenCV cannot build it.
    [[nodiscard]] static Result<SmallFigureNetwork> from_onnx(std::span<const std::byte> model);

    /// Returns how likely each place of an 8-bit BGR picture belongs to its main thing, 0..1, in
    /// the picture's proportions, by the limits of figures.h and the picture's colours
    /// (figure_colours.h). Fails, with one line, if the network is of another kind or cannot be
    /// run; throws std::bad_alloc without memory. Some 140 ms on one processor, of
    /// which the network takes 33.
    [[nodiscard]] Result<cv::Mat1f> likelihood(const cv::Mat3b& picture);

  private:
    explicit SmallFigureNetwork(TrainedNetwork network) : network_(std::move(network)) {}

    TrainedNetwork network_;
};

}  // namespace touchline
