// A picture with the grain of a camera.
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace touchline {

/// Returns the picture with normal noise in each channel, the same for the same seed. Any thread;
/// O(pixels).
inline cv::Mat3b with_noise(const cv::Mat3b& picture, double deviation, std::uint64_t seed) {
    cv::RNG random(seed);
    cv::Mat3s noise(picture.size());
    random.fill(noise, cv::RNG::NORMAL, 0.0, deviation);
    cv::Mat3b noisy;
    cv::add(picture, noise, noisy, {}, CV_8UC3);
    return noisy;
}

}  // namespace touchline
