#include "app/trace/page_lines.h"

#include "app/decode/answer_parts.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace touchline {
namespace {

constexpr int beside_words_px = 3;  // soft edges of letters reach out of their box

cv::Rect grown(const WordBox& box, const cv::Rect& whole) {
    const cv::Rect exact(box.left, box.top, box.right - box.left, box.bottom - box.top);
    const cv::Point by(beside_words_px, beside_words_px);
    return cv::Rect(exact.tl() - by, exact.br() + by) & whole;
}

/// The middle colour along the edge of a box, each channel by itself.
cv::Vec3b colour_around(const cv::Mat& bgr, const cv::Rect& box) {
    std::array<std::vector<std::uint8_t>, 3> edge;
    const auto take = [&](int x, int y) {
        const auto pixel = bgr.at<cv::Vec3b>(y, x);
        for (int channel = 0; channel < 3; ++channel)
            edge[static_cast<std::size_t>(channel)].push_back(pixel[channel]);
    };
    for (int x = box.x; x < box.x + box.width; ++x) {
        take(x, box.y);
        take(x, box.y + box.height - 1);
    }
    for (int y = box.y; y < box.y + box.height; ++y) {
        take(box.x, y);
        take(box.x + box.width - 1, y);
    }
    cv::Vec3b middle;
    for (int channel = 0; channel < 3; ++channel) {
        auto& values = edge[static_cast<std::size_t>(channel)];
        const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), half, values.end());
        middle[channel] = *half;
    }
    return middle;
}

/// A view of pixels that nobody may write to: only what takes a constant matrix may be given it.
cv::Mat view_of(const decode::AnswerParts& page) {
    return {static_cast<int>(page.header.height), static_cast<int>(page.header.width), CV_8UC3,
            const_cast<std::byte*>(page.pixels.data())};
}

void paint_over(cv::Mat& bgr, std::span<const WordBox> words) {
    const cv::Rect whole(0, 0, bgr.cols, bgr.rows);
    for (const WordBox& word : words) {
        const cv::Rect box = grown(word, whole);
        bgr(box).setTo(colour_around(bgr, box));
    }
}

}  // namespace

Result<Found> find_lines_of_page(std::span<const std::byte> page, const TraceOptions& options) {
    const auto parts = decode::parts_of(page);
    if (!parts) return tl::unexpected(parts.error());
    if (parts->header.kind != AnswerKind::page)
        return failure("there is no picture to find lines in");
    cv::Mat bgr = view_of(*parts);
    const std::span words(parts->boxes.data(), parts->header.boxes);
    if (!words.empty()) {
        bgr = bgr.clone();
        paint_over(bgr, words);
    }
    return find_lines(bgr, options);
}

}  // namespace touchline
