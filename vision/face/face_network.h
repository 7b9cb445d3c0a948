// The networks that find the faces in a photograph, lay a mesh on each and tell persons from the
// background, as ONNX files; a face with its person as a map.
// Threads: pure functions; one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "vision/face/face_lines.h"
#include "vision/face/face_map.h"
#include "vision/network/trained_network.h"

#include <optional>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

/// A place where a face may be, in pixels of the network's input or of a picture.
struct FaceBox {
    cv::Rect2d box;        // from the brows to the chin
    cv::Point2d left_eye;  // on the left of an upright face
    cv::Point2d right_eye;
    double likelihood = 0.0;  // 0.5..1
};

/// The side of the network's input, the largest square of places that it knows.
inline constexpr int face_input_px = 256;

/// Decodes the network's outputs. They have a row for each anchor, 16 x 16 x 2 of stride 16 and
/// then 8 x 8 x 6 of stride 32, each place's anchors one after the other, row by row. `scores`:
/// logits; `places`: centre, size and six points (x, y) about the anchor. Numbers are finite and
/// may be anything: a box that is not a box in the input, or has an eye far from it, is left out.
/// The likeliest come first, 16 at most; of two that share three tenths of the less likely, the
/// likelier stays. Source: Bazarevsky et al. 2019.
[[nodiscard]] std::vector<FaceBox> face_boxes(const cv::Mat1f& scores, const cv::Mat1f& places);

/// Adds those of `more` that lie on none of `boxes` yet, by the same measure. O(`more` x all).
void add_apart(const std::vector<FaceBox>& more, std::vector<FaceBox>& boxes);

/// The least width of a face that counts: the meshes of narrower ones are all about the same.
inline constexpr double least_face_px = 32.0;

/// Sources: BlazeFace (Bazarevsky et al. 2019), FaceMesh (Kartynnik et al. 2019).
class FaceNetwork {
  public:
    /// `finder`: BlazeFace of 256 x 256, `mesh`: FaceMesh of 192 x 192. Fails with one line if
    /// OpenCV cannot build one of them.
    [[nodiscard]] static Result<FaceNetwork> from_onnx(std::span<const std::byte> finder,
                                                       std::span<const std::byte> mesh);

    /// Returns the faces of an 8-bit BGR picture that are least_face_px wide or more, the widest
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
