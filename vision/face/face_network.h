// The networks that find the faces in a photograph and lay a mesh on each, as ONNX files.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/face/face_boxes.h"
#include "vision/face/face_mesh.h"
#include "vision/network/trained_network.h"

#include <optional>

namespace touchline {

/// The least width of a face that counts: the meshes of narrower ones are all about the same.
inline constexpr double kLeastFace_px = 32.0;

/// Sources: BlazeFace (Bazarevsky et al. 2019), FaceMesh (Kartynnik et al. 2019).
class FaceNetwork {
  public:
    /// `finder`: BlazeFace of 256 x 256, `mesh`: FaceMesh of 192 x 192. Fails with one line if
    /// OpenCV cannot build one of them.
    [[nodiscard]] static Result<FaceNetwork> from_onnx(std::span<const std::byte> finder,
                                                       std::span<const std::byte> mesh);

    /// Returns the faces of an 8-bit BGR picture that are kLeastFace_px wide or more, the widest
    /// first, at most 8. `persons`: boxes in its pixels, of which the first 8 count: a face only
    /// counts in such a box, since the networks find faces in statues too. Looks again in the upper
    /// part of each box, for heads that are small in the picture. Fails, with one line, if a
    /// network is of another kind or cannot be run; throws std::bad_alloc without memory. 80 ms for
    /// one person on one core, 30 more for each other.
    [[nodiscard]] Result<std::vector<FaceMesh>> faces(const cv::Mat3b& picture,
                                                      std::span<const cv::Rect2d> persons);

  private:
    struct Laid {
        FaceMesh mesh;
        double sure = 0.0;  // 0..1: likelihood that it lies on a face
    };

    FaceNetwork(TrainedNetwork finder, TrainedNetwork mesh)
        : finder_(std::move(finder)), mesh_(std::move(mesh)) {}

    [[nodiscard]] Result<std::vector<FaceBox>> boxes_in(const cv::Mat3b& picture, cv::Rect part);
    [[nodiscard]] Result<std::optional<Laid>> laid_on(const cv::Mat3b& picture, const FaceBox& box);

    TrainedNetwork finder_;
    TrainedNetwork mesh_;
};

}  // namespace touchline
