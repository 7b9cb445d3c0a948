#include "vision/camera/frame.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include <opencv2/imgproc.hpp>
#include <turbojpeg.h>

namespace touchline {
namespace {

using Decoder = std::unique_ptr<void, int (*)(tjhandle)>;

/// Cameras usually put padding between the scan and the end marker. All other warnings mean that
/// some pixels were guessed.
bool is_harmless(tjhandle decoder) {
    return tjGetErrorCode(decoder) == TJERR_WARNING &&
           std::string_view(tjGetErrorStr2(decoder)).find("extraneous bytes") !=
               std::string_view::npos;
}

tl::unexpected<Error> damaged(tjhandle decoder) {
    return failure(std::string("the camera's frame is damaged: ") + tjGetErrorStr2(decoder));
}

cv::Size divided(cv::Size size, int by) {
    return {(size.width + by - 1) / by, (size.height + by - 1) / by};
}

/// Returns the smallest of full, half, quarter and eighth size that is not below the wanted one:
/// libjpeg-turbo has vector code for these transforms.
cv::Size decoded_size(cv::Size size, cv::Size wanted) {
    for (const int by : {8, 4, 2}) {
        const cv::Size reduced = divided(size, by);
        if (reduced.width >= wanted.width && reduced.height >= wanted.height) return reduced;
    }
    return size;
}

Result<cv::Mat> decode_jpeg(const CameraFrame& frame, cv::Size wanted) {
    const Decoder decoder(tjInitDecompress(), tjDestroy);
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colours = 0;
    const auto bytes = static_cast<unsigned long>(frame.bytes.size());
    if (tjDecompressHeader3(decoder.get(), frame.bytes.data(), bytes, &width, &height, &subsampling,
                            &colours) != 0 &&
        !is_harmless(decoder.get()))
        return damaged(decoder.get());
    if (cv::Size(width, height) != frame.size)
        return failure("the camera's frame is damaged: its size is not the one agreed on");
    cv::Mat bgr(decoded_size(frame.size, wanted), CV_8UC3);
    if (tjDecompress2(decoder.get(), frame.bytes.data(), bytes, bgr.data, bgr.cols,
                      static_cast<int>(bgr.step), bgr.rows, TJPF_BGR, TJFLAG_FASTDCT) != 0 &&
        !is_harmless(decoder.get()))
        return damaged(decoder.get());
    return bgr;
}

std::size_t least_stride(const CameraFrame& frame) {
    const auto width = static_cast<std::size_t>(frame.size.width);
    switch (frame.format) {
        case PixelFormat::mjpeg:
            return 0;
        case PixelFormat::yuyv:
            return 2 * width;
        case PixelFormat::nv12:
            return width;
        case PixelFormat::bgr:
            return 3 * width;
    }
    return 0;
}

/// Returns the number of bytes that a frame's rows take; the last row need not be padded.
std::size_t least_bytes(const CameraFrame& frame) {
    if (frame.format == PixelFormat::mjpeg) return 1;
    const auto height = static_cast<std::size_t>(frame.size.height);
    const std::size_t rows = frame.format == PixelFormat::nv12 ? height + height / 2 : height;
    return frame.stride_bytes * (rows - 1) + least_stride(frame);
}

bool has_odd_size(const CameraFrame& frame) {
    if (frame.format == PixelFormat::yuyv) return frame.size.width % 2 != 0;
    if (frame.format == PixelFormat::nv12)
        return frame.size.width % 2 != 0 || frame.size.height % 2 != 0;
    return false;
}

cv::Mat rows_of(const CameraFrame& frame, int type, std::size_t offset, cv::Size size) {
    // OpenCV has no read-only view; nothing writes through this one.
    auto* data = const_cast<std::uint8_t*>(frame.bytes.data() + offset);
    return {size, type, data, frame.stride_bytes};
}

/// Averages brightness and colour down before it mixes them, which is less work; the pairs of
/// colour need even sides for that.
cv::Mat convert_nv12(const CameraFrame& frame, cv::Size wanted) {
    const cv::Mat luma = rows_of(frame, CV_8UC1, 0, frame.size);
    const cv::Mat chroma =
        rows_of(frame, CV_8UC2, frame.stride_bytes * static_cast<std::size_t>(frame.size.height),
                {frame.size.width / 2, frame.size.height / 2});
    const bool is_even = wanted.width % 2 == 0 && wanted.height % 2 == 0;
    const cv::Size size = is_even ? wanted : frame.size;
    cv::Mat small_luma;
    cv::Mat small_chroma;
    cv::resize(luma, small_luma, size, 0, 0, cv::INTER_AREA);
    cv::resize(chroma, small_chroma, size / 2, 0, 0, cv::INTER_AREA);
    cv::Mat bgr;
    cv::cvtColorTwoPlane(small_luma, small_chroma, bgr, cv::COLOR_YUV2BGR_NV12);
    return bgr;
}

}  // namespace

cv::Size reduced_size(cv::Size size, std::int64_t pixels) {
    const double area = static_cast<double>(size.width) * size.height;
    const double scale = std::min(1.0, std::sqrt(static_cast<double>(pixels) / area));
    const auto scaled = [&](int side) { return static_cast<int>(side * scale); };
    // A side that would vanish becomes 1, and the other one gets all the pixels.
    const auto most = [&](int side) {
        return static_cast<int>(std::min<std::int64_t>(side, std::max<std::int64_t>(1, pixels)));
    };
    if (scaled(size.height) < 1) return {most(size.width), 1};
    if (scaled(size.width) < 1) return {1, most(size.height)};
    return {scaled(size.width), scaled(size.height)};
}

cv::Size quick_size(cv::Size size, std::int64_t pixels) {
    for (const int by : {1, 2, 4}) {
        const cv::Size reduced = divided(size, by);
        if (std::int64_t{reduced.width} * reduced.height <= pixels) return reduced;
    }
    return divided(size, 8);
}

Result<cv::Mat> to_bgr(const CameraFrame& frame, cv::Size wanted) {
    if (frame.size.width < 1 || frame.size.height < 1 || has_odd_size(frame) ||
        frame.stride_bytes < least_stride(frame) || frame.bytes.size() < least_bytes(frame))
        return failure("the camera's frame is damaged: bytes are missing");
    cv::Mat bgr;
    if (frame.format == PixelFormat::mjpeg) {
        auto decoded = decode_jpeg(frame, wanted);
        if (!decoded) return decoded;
        bgr = std::move(*decoded);
    } else if (frame.format == PixelFormat::nv12) {
        bgr = convert_nv12(frame, wanted);
    } else if (frame.format == PixelFormat::yuyv) {
        cv::cvtColor(rows_of(frame, CV_8UC2, 0, frame.size), bgr, cv::COLOR_YUV2BGR_YUYV);
    } else {
        bgr = rows_of(frame, CV_8UC3, 0, frame.size);
    }
    if (bgr.size() == wanted) return bgr.clone();
    cv::Mat out;
    cv::resize(bgr, out, wanted, 0, 0, cv::INTER_AREA);
    return out;
}

FrameQuality measure_quality(const cv::Mat& bgr) {
    cv::Mat grey;
    cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
    cv::Mat laplacian;
    cv::Laplacian(grey, laplacian, CV_16S);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(laplacian, mean, deviation);
    constexpr int clipped_from = 253;  // converters and compression stop a little below 255
    const int clipped = cv::countNonZero(grey >= clipped_from);
    return {deviation[0] * deviation[0],
            static_cast<double>(clipped) / static_cast<double>(grey.total()), cv::mean(grey)[0]};
}

}  // namespace touchline
