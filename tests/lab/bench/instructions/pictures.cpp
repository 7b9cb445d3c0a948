#include "tests/lab/bench/instructions/pictures.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

cv::Scalar grey(int level) {
    return cv::Scalar::all(level);
}

}  // namespace

cv::Mat drawing() {
    cv::Mat picture(866, 1154, CV_8UC3, grey(235));
    for (int i = 0; i < 40; ++i) {
        const cv::Point at(80 + 140 * (i % 8), 90 + 170 * (i / 8));
        if (i % 2 == 0) {
            cv::circle(picture, at, 30 + i % 7 * 4, cv::Scalar(20 + 4 * i, 60, 200 - 4 * i), -1);
        } else {
            cv::rectangle(picture, at - cv::Point(40, 30 + i), at + cv::Point(40, 30 + i),
                          grey(3 * i), -1);
        }
    }
    return picture;
}

cv::Mat photo() {
    cv::RNG random(7);
    const auto clouds = [&random](cv::Size size) {
        cv::Mat sum(size, CV_32FC3, grey(120));
        for (const int cells : {4, 12, 40, 120}) {
            cv::Mat octave(cells, cells, CV_32FC3);
            random.fill(octave, cv::RNG::NORMAL, 0.0, 70.0 / std::sqrt(cells));
            cv::resize(octave, octave, size, 0.0, 0.0, cv::INTER_CUBIC);
            sum += octave;
        }
        return sum;
    };
    const cv::Size size(1154, 866);
    cv::Mat picture = clouds(size);
    const cv::Mat other = clouds(size) + grey(70);
    for (int i = 0; i < 12; ++i) {
        cv::Mat1b disc(size, uchar{0});
        cv::circle(disc, {150 + 280 * (i % 4), 140 + 280 * (i / 4)}, 60 + 5 * i, 255, -1);
        other.copyTo(picture, disc);
    }
    picture.convertTo(picture, CV_8U);
    return picture;
}

}  // namespace touchline::bench
