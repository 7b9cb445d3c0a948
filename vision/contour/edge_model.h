// A boundary network that the operator supplies as an ONNX file. None ships with Touchline: what is
// free is not good, and what is good is not free.
// Threads: one object, one thread at a time (OpenCV may use its own threads inside).
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include <opencv2/core.hpp>

namespace touchline {

/// How every line begins that says what is wrong with a network.
inline constexpr std::string_view unusable_edge_model = "the edge model cannot be used";

/// The network takes one picture, 1 x 3 x height x width, planes red, green, blue, values 0 to 1
/// (other means and scales belong into the model when it is exported), and gives its last output as
/// 1 x 1 x height x width, at any scale: the probability of a boundary, or its logit (recognised by
/// values outside 0..1). Height and width may be fixed or free; where free they are multiples
/// of 32.
class EdgeModel {
  public:
    /// Builds the network and tries it once. Fails with one line that says what is wrong with it.
    [[nodiscard]] static Result<EdgeModel> from_onnx(std::span<const std::byte> model);

    EdgeModel(EdgeModel&&) noexcept;
    EdgeModel& operator=(EdgeModel&&) noexcept;
    ~EdgeModel();

    /// Probability of a boundary at each pixel of an 8-bit picture, BGR or grey; 0..1, the
    /// picture's size. Fails where the network does. Some seconds a megapixel with a network of a
    /// million parameters.
    [[nodiscard]] Result<cv::Mat1f> boundaries(const cv::Mat& picture);

  private:
    struct Network;
    explicit EdgeModel(std::unique_ptr<Network> network);
    std::unique_ptr<Network> network_;
};

}  // namespace touchline
