// The work that valgrind --tool=callgrind counts: the way from pixels to a map, once for a drawing
// of one megapixel and once for a photo. Each dump is named after its contents. Without valgrind
// the requests do nothing, and nothing is written.
#include "vision/simplify/trace.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <opencv2/imgproc.hpp>
#include <valgrind/callgrind.h>

/// The counted function: neither inlined nor cloned, with an unmangled name.
extern "C" [[gnu::noipa]] void touchline_picture_map(const cv::Mat& picture,
                                                     touchline::TactileMap& map) {
    map = touchline::trace_outlines(picture, {.area = {}, .detail = 5}).value().map;
}

namespace {

cv::Scalar grey(int level) {
    return cv::Scalar::all(level);
}

/// Forty shapes on paper, with a little noise.
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

/// Clouds of four sizes and twelve discs of other clouds: nearly every pixel changes.
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

void count(const cv::Mat& picture, const char* name) {
    touchline::TactileMap map;
    touchline_picture_map(picture, map);  // builds once what is built only once, uncounted
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    touchline_picture_map(picture, map);
    CALLGRIND_DUMP_STATS_AT(name);
    CALLGRIND_STOP_INSTRUMENTATION;
    if (map.outlines.size() < 12) {
        std::fputs("what is counted is no work: hardly any lines were found\n", stderr);
        std::exit(EXIT_FAILURE);
    }
}

}  // namespace

int main() {
    cv::setNumThreads(1);
    count(drawing(), "drawing 1MP 1");
    count(photo(), "photo 1MP 1");
}
