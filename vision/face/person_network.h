// The network that tells persons from what lies behind them, as an ONNX file.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/network/trained_network.h"

namespace touchline {

/// Source: MediaPipe's selfie segmentation of 256 x 256, which stretches what it sees to a square.
class PersonNetwork {
  public:
    /// Fails with one line where OpenCV cannot build it.
    [[nodiscard]] static Result<PersonNetwork> from_onnx(std::span<const std::byte> model);

    /// A mask of 256 x 256 that stands for a part of an 8-bit BGR picture, in which it lies: how
    /// likely a place belongs to a person, 128 for as likely as not. It finds persons in animals
    /// and in fire too: ask it only where there is one. Fails, with one line, where the network is
    /// of another kind, or cannot be run; throws std::bad_alloc without memory. 11 ms on one core.
    [[nodiscard]] Result<cv::Mat1b> mask_of(const cv::Mat3b& picture, const cv::Rect& part);

  private:
    explicit PersonNetwork(TrainedNetwork network) : network_(std::move(network)) {}

    TrainedNetwork network_;
};

}  // namespace touchline
