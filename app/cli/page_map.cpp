#include "app/cli/page_map.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>
#include <opencv2/core.hpp>

namespace touchline {
namespace {

constexpr int beside_words_px = 3;  // soft edges of letters reach out of their box

cv::Mat pixels_of(Picture& picture) {
    return {picture.height, picture.width, CV_8UC3, picture.bgr.data()};
}

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

/// Labels from the page's area to that of the map; the picture is fitted in it, centred.
std::vector<Label> placed(std::vector<Label> labels, const Area& from, const Area& to) {
    const double scale = std::min(to.width_m / from.width_m, to.height_m / from.height_m);
    for (Label& label : labels) label.place = {scale * label.place.x, scale * label.place.y};
    return labels;
}

}  // namespace

Picture without_words(const Page& page) {
    Picture picture = page.picture;
    cv::Mat bgr = pixels_of(picture);
    const cv::Rect whole(0, 0, bgr.cols, bgr.rows);
    for (const WordBox& word : page.words) {
        const cv::Rect box = grown(word, whole);
        bgr(box).setTo(colour_around(bgr, box));
    }
    return picture;
}

Result<Found> find_page_lines(const Page& page, const TraceOptions& options) {
    Picture picture = without_words(page);
    return find_lines(pixels_of(picture), options);
}

Result<Trace> trace_page_lines(const Page& page, const Found& found, const TraceOptions& options) {
    auto trace = trace_lines(found, options);
    if (!trace) return trace;
    trace->map.title = page.told.title;
    trace->map.description = page.told.description;
    trace->map.labels = enlarged(placed(page.told.labels, page.told.area, options.area),
                                 options.area, options.zoom);
    return trace;
}

Result<Trace> trace_page(const Page& page, const TraceOptions& options) {
    return find_page_lines(page, options).and_then([&](const Found& found) {
        return trace_page_lines(page, found, options);
    });
}

Result<TactileMap> shown_at(TactileMap map, int detail) {
    std::erase_if(map.outlines,
                  [detail](const Outline& outline) { return outline.detail > detail; });
    if (map.outlines.empty())
        return failure(
            fmt::format("no outline is shown at detail {}; choose a higher detail", detail));
    return map;
}

Result<TactileMap> drawn_lines(const Page& page, int detail) {
    if (page.told.outlines.empty()) return failure("the picture has no lines of its own");
    return shown_at(page.told, detail);
}

}  // namespace touchline
