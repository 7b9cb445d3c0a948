// A trained network as an ONNX file, run by OpenCV.
// Threads: one object, one thread at a time (OpenCV uses its own inside).
#pragma once

#include "config/types/result.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {

class TrainedNetwork {
  public:
    /// `job`: what it does, as the words after "the network that". Fails with one line if OpenCV
    /// cannot build it.
    [[nodiscard]] static Result<TrainedNetwork> from_onnx(std::span<const std::byte> model,
                                                          std::string job);

    TrainedNetwork(TrainedNetwork&&) noexcept;
    TrainedNetwork& operator=(TrainedNetwork&&) noexcept;
    ~TrainedNetwork();

    /// Runs the network on an input of four dimensions. Returns its outputs of these shapes, which
    /// must differ, in their order; each has one row for every place of all dimensions but the
    /// last. All numbers are finite. Fails, with one line, if it cannot be run or has no such
    /// output; throws std::bad_alloc without memory.
    [[nodiscard]] Result<std::vector<cv::Mat1f>> outputs(const cv::Mat& input,
                                                         std::span<const std::vector<int>> shapes);

    /// The same for a network with one output: likelihoods, 0..1. Fails too if one is not.
    [[nodiscard]] Result<cv::Mat1f> likelihoods(const cv::Mat& input,
                                                const std::vector<int>& shape);

    /// Returns the error for a caller that finds the numbers of an answer wrong.
    [[nodiscard]] tl::unexpected<Error> unusable(const std::string& why) const;

  private:
    struct Run;
    explicit TrainedNetwork(std::unique_ptr<Run> run);
    std::unique_ptr<Run> run_;
};

/// Returns a picture at another size. Shrinking averages the pixels that become one; enlarging
/// interpolates smoothly. O(pixels).
[[nodiscard]] cv::Mat3b stretched(const cv::Mat3b& picture, cv::Size size);

/// Returns whether all of them are likelihoods, give or take a rounding.
[[nodiscard]] bool are_likelihoods(const cv::Mat1f& values);

}  // namespace touchline
