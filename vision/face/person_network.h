// The network that tells persons from the background, as an ONNX file; where people are in a
// picture, and a face with its person as a map.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/face/face_map.h"
#include "vision/network/trained_network.h"

#include <span>

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

/// Returns how likely each pixel of an 8-bit BGR picture belongs to a person, 0..1; 0 outside of
/// `people`, boxes in its pixels, each grown by 0.04 of its longer side on all sides. Boxes of an
/// eightieth of the picture or more count, at most five, in their order. Boxes may be anything:
/// those that lie beside the picture, have no size, or have NaN or infinite numbers do not count.
/// Fails as the network does. 11 ms for each on one core.
[[nodiscard]] Result<cv::Mat1f> people_likelihood(const cv::Mat3b& picture,
                                                  std::span<const cv::Rect2d> people,
                                                  PersonNetwork& network);

/// Returns the map of a mesh that lies on a face of an 8-bit BGR picture, in the area's usual size.
/// Fails as the network does. 24 ms on one core.
[[nodiscard]] Result<FaceMap> drawn_face(const cv::Mat3b& picture, const FaceMesh& mesh,
                                         PersonNetwork& persons);

}  // namespace touchline
