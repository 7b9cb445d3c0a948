#include "tests/vision/camera/frames.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

#include <opencv2/imgproc.hpp>
#include <turbojpeg.h>

namespace touchline::testing {
namespace {

/// Converts to BT.601, 16 ... 235, the coding of video.
std::array<std::uint8_t, 3> yuv_of(const cv::Vec3d& bgr) {
    const double y = 0.257 * bgr[2] + 0.504 * bgr[1] + 0.098 * bgr[0] + 16.0;
    const double u = -0.148 * bgr[2] - 0.291 * bgr[1] + 0.439 * bgr[0] + 128.0;
    const double v = 0.439 * bgr[2] - 0.368 * bgr[1] - 0.071 * bgr[0] + 128.0;
    return {cv::saturate_cast<std::uint8_t>(y), cv::saturate_cast<std::uint8_t>(u),
            cv::saturate_cast<std::uint8_t>(v)};
}

std::array<std::uint8_t, 3> yuv_at(const cv::Mat& bgr, int x, int y) {
    return yuv_of(bgr.at<cv::Vec3b>(y, x));
}

constexpr std::uint8_t padding = 0x5a;

}  // namespace

cv::Mat scene(cv::Size size) {
    cv::Mat picture(size, CV_8UC3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            picture.at<cv::Vec3b>(y, x) =
                cv::Vec3b(static_cast<std::uint8_t>(40 + 60 * x / size.width),
                          static_cast<std::uint8_t>(70 + 40 * y / size.height), 120);
    const cv::Rect page(size.width / 6, size.height / 8, size.width * 2 / 3, size.height * 3 / 4);
    cv::rectangle(picture, page, {235, 240, 242}, cv::FILLED);
    const double scale = size.width / 800.0;
    const int thickness = std::max(1, static_cast<int>(2 * scale));
    for (int line = 1; line < 8; ++line)
        cv::putText(picture, "The fish swims home", {page.x + 20, page.y + line * page.height / 9},
                    cv::FONT_HERSHEY_SIMPLEX, 1.2 * scale, {30, 20, 20}, thickness, cv::LINE_AA);
    cv::circle(picture, {page.x + page.width * 3 / 4, page.y + page.height * 3 / 4},
               size.height / 9, {40, 40, 200}, cv::FILLED, cv::LINE_AA);
    return picture;
}

CameraFrame yuyv_frame(const cv::Mat& bgr, std::size_t padding_bytes) {
    CameraFrame frame{
        PixelFormat::yuyv, bgr.size(), 2 * static_cast<std::size_t>(bgr.cols) + padding_bytes, {}};
    for (int y = 0; y < bgr.rows; ++y) {
        for (int x = 0; x < bgr.cols; x += 2) {
            const auto left = yuv_at(bgr, x, y);
            const auto right = yuv_at(bgr, x + 1, y);
            for (const int value :
                 {int{left[0]}, (left[1] + right[1]) / 2, int{right[0]}, (left[2] + right[2]) / 2})
                frame.bytes.push_back(static_cast<std::uint8_t>(value));
        }
        frame.bytes.insert(frame.bytes.end(), padding_bytes, padding);
    }
    return frame;
}

CameraFrame nv12_frame(const cv::Mat& bgr, std::size_t padding_bytes) {
    CameraFrame frame{
        PixelFormat::nv12, bgr.size(), static_cast<std::size_t>(bgr.cols) + padding_bytes, {}};
    for (int y = 0; y < bgr.rows; ++y) {
        for (int x = 0; x < bgr.cols; ++x) frame.bytes.push_back(yuv_at(bgr, x, y)[0]);
        frame.bytes.insert(frame.bytes.end(), padding_bytes, padding);
    }
    cv::Mat half;
    cv::resize(bgr, half, bgr.size() / 2, 0, 0, cv::INTER_AREA);
    for (int y = 0; y < half.rows; ++y) {
        for (int x = 0; x < half.cols; ++x) {
            frame.bytes.push_back(yuv_at(half, x, y)[1]);
            frame.bytes.push_back(yuv_at(half, x, y)[2]);
        }
        frame.bytes.insert(frame.bytes.end(), padding_bytes, padding);
    }
    return frame;
}

CameraFrame mjpeg_frame(const cv::Mat& bgr, int quality) {
    tjhandle encoder = tjInitCompress();
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    if (tjCompress2(encoder, bgr.data, bgr.cols, static_cast<int>(bgr.step), bgr.rows, TJPF_BGR,
                    &bytes, &size, TJSAMP_422, quality, 0) != 0)
        throw std::runtime_error(tjGetErrorStr2(encoder));
    CameraFrame frame{PixelFormat::mjpeg, bgr.size(), 0, {bytes, bytes + size}};
    tjFree(bytes);
    tjDestroy(encoder);
    return frame;
}

CameraFrame without_tables(CameraFrame mjpeg) {
    constexpr std::array<std::uint8_t, 18> avi1{0xff, 0xe0, 0, 16, 'A', 'V', 'I', '1'};
    std::vector<std::uint8_t>& in = mjpeg.bytes;
    std::vector<std::uint8_t> out;
    const auto append = [&](std::size_t from, std::size_t count) {
        std::copy_n(in.begin() + static_cast<std::ptrdiff_t>(from), count, std::back_inserter(out));
    };
    append(0, 2);
    std::ranges::copy(avi1, std::back_inserter(out));
    std::size_t at = 2;
    while (in[at + 1] != 0xda) {
        const std::size_t length = 2 + (std::size_t{in[at + 2]} << 8U) + in[at + 3];
        const bool is_dropped = in[at + 1] == 0xc4 || in[at + 1] == 0xe0;
        if (!is_dropped) append(at, length);
        at += length;
    }
    append(at, in.size() - at);
    in = std::move(out);
    return mjpeg;
}

double mean_difference(const cv::Mat& a, const cv::Mat& b) {
    return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(3 * a.total());
}

}  // namespace touchline::testing
