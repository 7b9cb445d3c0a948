// The network that tells persons from the background, as an ONNX file.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/network/trained_network.h"

namespace touchline {

/// Source: MediaPipe's selfie segmentation of 256 x 256, which stretches its input to a square.
class PersonNetwork {
  public:
    /// Fails with one line if OpenCV cannot build it.
    [[nodiscard]] static Result<PersonNetwork> from_onnx(std::span<const std::byte> model);

    /// Returns a mask of 256 x 256 for a part of an 8-bit BGR picture, which holds the part: how
    /// likely a place belongs to a person, 128 for as likely as not. It finds persons in animals
    /// and in fire too, so ask it only where there is one. Fails, with one line, if the network is
    /// of another kind or cannot be run; throws std::bad_alloc without memory. 11 ms on one core.
    [[nodiscard]] Result<cv::Mat1b> mask_of(const cv::Mat3b& picture, const cv::Rect& part);

  private:
    explicit PersonNetwork(TrainedNetwork network) : network_(std::move(network)) {}

    TrainedNetwork network_;
};

}  // namespace touchline
