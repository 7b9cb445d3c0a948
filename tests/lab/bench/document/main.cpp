// document_bench [ROUNDS]: measures what each step costs from a 12-megapixel MJPEG frame, as USB
// cameras give it, to the page, evenly lit, at a megapixel. Prints one row a step: least and median
// time over the rounds.
#include "config/types/steady_clock.h"
#include "tests/vision/camera/frames.h"
#include "tests/vision/prepare/page_photos.h"
#include "vision/camera/frame.h"
#include "vision/prepare/document.h"
#include "vision/prepare/page_light.h"
#include "vision/prepare/quad.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace {

using namespace touchline;

const cv::Size still_size(4000, 3000);

void measure(const char* step, int rounds, const std::function<void()>& work) {
    std::vector<double> times_ms;
    for (int i = 0; i < rounds; ++i) {
        const auto start_ns = steady_now_ns();
        work();
        times_ms.push_back(1e-6 * static_cast<double>(steady_now_ns() - start_ns));
    }
    std::sort(times_ms.begin(), times_ms.end());
    std::printf("| %s | %.1f | %.1f |\n", step, times_ms.front(), times_ms[times_ms.size() / 2]);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 9;
    testing::Hardship hardship;
    hardship.page_share = 0.8;
    hardship.shade = 0.3;
    cv::Mat large;
    cv::resize(testing::page_photo(11, hardship).bgr, large, still_size, 0, 0, cv::INTER_CUBIC);
    const CameraFrame frame = testing::without_tables(testing::mjpeg_frame(large));
    std::printf("a JPEG of %zu kB\n| step | least ms | middle ms |\n|---|---|---|\n",
                frame.bytes.size() / 1000);
    cv::Mat pixels;
    for (const int by : {1, 2, 4})
        measure(by == 1   ? "decode, whole"
                : by == 2 ? "decode, a half"
                          : "decode, a quarter",
                rounds, [&] { pixels = *to_bgr(frame, still_size / by); });
    measure("decode and average to a megapixel", rounds,
            [&] { pixels = *to_bgr(frame, reduced_size(still_size, 1'000'000)); });
    pixels = *to_bgr(frame, still_size / 4);
    measure("sharpness and clipping, 0.75 megapixel", rounds,
            [&] { (void)measure_quality(pixels); });
    const cv::Mat half = *to_bgr(frame, still_size / 2);
    PageSearch search;
    for (const cv::Mat& picture : {pixels, half}) {
        const bool is_half = picture.cols == half.cols;
        measure(is_half ? "page search, 3 megapixels" : "page search, 0.75 megapixel", rounds,
                [&] { search = find_page(picture); });
        if (!search.corners) return 1;
        const double aspect = aspect_of(*search.corners, picture.size());
        cv::Mat page;
        measure(is_half ? "rectified from 3 megapixels" : "rectified from 0.75 megapixel", rounds,
                [&] { page = rectified(picture, *search.corners, aspect); });
        measure(is_half ? "evenly lit, from 3 megapixels" : "evenly lit, from 0.75 megapixel",
                rounds, [&] { (void)evenly_lit(page); });
    }
    return 0;
}
