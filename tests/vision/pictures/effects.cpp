#include "tests/vision/pictures/effects.h"

#include "tests/app/documents/decode/decoding_here.h"
#include "tests/app/documents/decode/encoders.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

cv::Mat through_jpeg(const cv::Mat& picture, int quality) {
    Picture plain{picture.cols, picture.rows, {}};
    const cv::Mat packed = picture.isContinuous() ? picture : picture.clone();
    plain.bgr.assign(packed.datastart, packed.dataend);
    encoders::JpegForm form;
    form.quality = quality;
    const Picture back = decode_picture(encoders::jpeg(plain, form)).value();
    cv::Mat decoded(picture.size(), CV_8UC3);
    std::copy(back.bgr.begin(), back.bgr.end(), decoded.ptr());
    return decoded;
}

cv::Mat with_gain(const cv::Mat& picture, double gain) {
    cv::Mat made;
    picture.convertTo(made, CV_8U, gain);
    return made;
}

cv::Mat with_gamma(const cv::Mat& picture, double gamma) {
    cv::Mat1b table(1, 256);
    for (int i = 0; i < 256; ++i) {
        table(i) = cv::saturate_cast<uchar>(255.0 * std::pow(i / 255.0, gamma));
    }
    cv::Mat made;
    cv::LUT(picture, table, made);
    return made;
}

}  // namespace

cv::Mat seen(const cv::Mat& picture, const Effects& effects) {
    cv::Mat3f light;
    picture.convertTo(light, CV_32F);
    const auto shade = static_cast<float>(effects.shade);
    for (int y = 0; y < light.rows; ++y) {
        for (int x = 0; x < light.cols; ++x) {
            const float across = static_cast<float>(x) / static_cast<float>(light.cols);
            const float down = static_cast<float>(y) / static_cast<float>(light.rows);
            light(y, x) *= 1.0F - shade * 0.5F * (across + down);
        }
    }
    if (effects.blur_px > 0.0) {
        cv::GaussianBlur(light, light, cv::Size(), effects.blur_px);
    }
    if (effects.noise_levels > 0.0) {
        cv::RNG random(static_cast<std::uint64_t>(effects.seed) + 77U);
        cv::Mat3f noise(light.size());
        random.fill(noise, cv::RNG::NORMAL, 0.0, effects.noise_levels);
        light += noise;
    }
    cv::Mat bytes;
    light.convertTo(bytes, CV_8U);
    return effects.jpeg_quality > 0 ? through_jpeg(bytes, effects.jpeg_quality) : bytes;
}

Effects effects_of_kind(int kind, int seed) {
    switch (kind % 6) {
        case 0:
            return {.seed = seed};
        case 1:
            return {.blur_px = 1.2, .seed = seed};
        case 2:
            return {.noise_levels = 8.0, .seed = seed};
        case 3:
            return {.noise_levels = 2.0, .shade = 0.5, .seed = seed};
        case 4:
            return {.jpeg_quality = 50, .seed = seed};
        default:
            return {.blur_px = 0.8,
                    .noise_levels = 4.0,
                    .shade = 0.3,
                    .jpeg_quality = 75,
                    .seed = seed};
    }
}

std::vector<Degraded> degraded(const cv::Mat& picture) {
    return {{"gain 0.6", with_gain(picture, 0.6)},
            {"gain 1.3", with_gain(picture, 1.3)},
            {"gamma 0.6", with_gamma(picture, 0.6)},
            {"50 % shade", seen(picture, {.shade = 0.5})},
            {"noise 5", seen(picture, {.noise_levels = 5.0})},
            {"JPEG 50", seen(picture, {.jpeg_quality = 50})},
            {"blur 1", seen(picture, {.blur_px = 1.0})}};
}

}  // namespace touchline::testing
