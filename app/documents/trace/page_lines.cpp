#include "app/documents/trace/page_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int beside_words_px = 3;   // soft edges of letters reach out of their box
constexpr double beyond_box = 0.25;  // of the box's shorter side: how far letters lean out,
constexpr int most_beyond_px = 16;   // and at most this far for large letters
constexpr int least_contrast = 30;   // grey levels between letters and their background
constexpr double large_box = 0.05;   // of the picture's height: words across the drawing
constexpr int like_letters = 40;     // grey levels around the colours of letters and their edges

cv::Rect exact(const WordBox& box) {
    return {box.left, box.top, box.right - box.left, box.bottom - box.top};
}

cv::Rect grown(const cv::Rect& box, int by_px, const cv::Rect& whole) {
    const cv::Point by(by_px, by_px);
    return cv::Rect(box.tl() - by, box.br() + by) & whole;
}

/// The median colour along the edge of a box, each channel by itself.
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

/// Pixels that differ from a colour by more than `levels` in some channel.
cv::Mat1b differing(const cv::Mat& bgr, const cv::Vec3b& colour, int levels) {
    cv::Mat difference;
    cv::absdiff(bgr, cv::Scalar(colour[0], colour[1], colour[2]), difference);
    cv::Mat1b mask(bgr.size());
    std::transform(difference.begin<cv::Vec3b>(), difference.end<cv::Vec3b>(), mask.begin(),
                   [levels](const cv::Vec3b& d) {
                       return static_cast<uchar>(std::max({d[0], d[1], d[2]}) > levels ? 255 : 0);
                   });
    return mask;
}

/// Pixels near a colour between the two: those of letters and of their soft edges.
cv::Mat1b between(const cv::Mat& bgr, const cv::Vec3b& ground, const cv::Vec3b& letter) {
    const cv::Vec3d way = cv::Vec3d(letter) - cv::Vec3d(ground);
    const double length = std::max(way.dot(way), 1.0);
    cv::Mat1b mask(bgr.size());
    std::transform(bgr.begin<cv::Vec3b>(), bgr.end<cv::Vec3b>(), mask.begin(),
                   [&](const cv::Vec3b& pixel) {
                       const cv::Vec3d from = cv::Vec3d(pixel) - cv::Vec3d(ground);
                       const double part = std::clamp(from.dot(way) / length, 0.0, 1.0);
                       const cv::Vec3d off = from - part * way;
                       const bool is_near = cv::norm(off, cv::NORM_INF) <= like_letters;
                       return static_cast<uchar>(is_near ? 255 : 0);
                   });
    return mask;
}

/// The common colours under a mask, to within 32 levels; at least one if the mask holds any pixel.
std::vector<cv::Vec3b> common_colours(const cv::Mat& bgr, const cv::Mat1b& mask) {
    constexpr int times_commoner = 4;  // no other colour is this much commoner
    std::map<std::array<int, 3>, std::pair<int, cv::Vec3i>> bins;
    int most = 0;
    for (int y = 0; y < bgr.rows; ++y)
        for (int x = 0; x < bgr.cols; ++x) {
            if (mask(y, x) == 0) continue;
            const auto p = bgr.at<cv::Vec3b>(y, x);
            auto& [count, sum] = bins[{p[0] / 32, p[1] / 32, p[2] / 32}];
            sum += cv::Vec3i(p);
            most = std::max(most, ++count);
        }
    std::vector<cv::Vec3b> colours;
    for (const auto& [place, bin] : bins)
        if (times_commoner * bin.first >= most) colours.emplace_back(bin.second / bin.first);
    return colours;
}

/// The ink of a letter's colour with its soft edges, without lines of another colour, so that what
/// crosses a letter does not connect it to the outside.
cv::Mat1b in_colour(const cv::Mat& bgr, const cv::Mat1b& ink, const cv::Vec3b& ground,
                    const cv::Vec3b& letter) {
    cv::Mat1b core;
    cv::subtract(ink, differing(bgr, letter, like_letters), core);
    cv::Mat1b around;
    cv::dilate(core, around, cv::Mat::ones(5, 5, CV_8U));
    cv::Mat1b of_letters = between(bgr, ground, letter);
    of_letters &= ink;
    of_letters &= around;
    cv::Mat1b others;
    cv::subtract(ink, of_letters, others);
    cv::Mat beside;
    cv::dilate(others, beside, cv::Mat::ones(3, 3, CV_8U));
    of_letters.setTo(0, beside);
    return of_letters;
}

/// The pieces of ink in a window that lie wholly within a box: letters. Lines that run beneath the
/// words leave the box.
cv::Mat letters_in(const cv::Mat1b& ink, const cv::Rect& box) {
    cv::Mat1i label;
    cv::Mat1i stats;
    cv::Mat1d centres;
    cv::connectedComponentsWithStats(ink, label, stats, centres, 8, CV_32S);
    cv::Mat letters(ink.size(), CV_8U, cv::Scalar(0));
    for (int piece = 1; piece < stats.rows; ++piece) {
        const cv::Rect extent(stats(piece, cv::CC_STAT_LEFT), stats(piece, cv::CC_STAT_TOP),
                              stats(piece, cv::CC_STAT_WIDTH), stats(piece, cv::CC_STAT_HEIGHT));
        if ((extent & box) == extent) letters.setTo(255, label == piece);
    }
    return letters;
}

/// The letters in the common colour that has the most enclosed ink in the box.
cv::Mat coloured_letters(const cv::Mat& part, const cv::Mat1b& ink, const cv::Vec3b& ground,
                         const cv::Rect& box, const cv::Rect& reach) {
    cv::Mat best(ink.size(), CV_8U, cv::Scalar(0));
    int most = 0;
    for (const cv::Vec3b& letter : common_colours(part(box), ink(box))) {
        const cv::Mat letters = letters_in(in_colour(part, ink, ground, letter), reach);
        const int area = cv::countNonZero(letters(box));
        if (area > most) best = letters;
        most = std::max(most, area);
    }
    return best;
}

/// Paints letters over, because they are heard, not felt. Their background, and lines beneath them,
/// stay.
void paint_over(cv::Mat& bgr, std::span<const WordBox> words) {
    const cv::Rect whole(0, 0, bgr.cols, bgr.rows);
    for (const WordBox& word : words) {
        const cv::Rect box = exact(word) & whole;
        if (box.empty()) continue;
        const int shorter_px = std::min(box.width, box.height);
        const int lean_px =
            beside_words_px + std::min(static_cast<int>(beyond_box * shorter_px), most_beyond_px);
        const cv::Rect window = grown(box, 2 * lean_px, whole);
        const cv::Rect reach = grown(box, lean_px, whole) - window.tl();
        cv::Mat part = bgr(window);
        const cv::Vec3b ground = colour_around(bgr, grown(box, beside_words_px, whole));
        const cv::Mat1b ink = differing(part, ground, least_contrast);
        cv::Mat inner = coloured_letters(part, ink, ground, box - window.tl(), reach);
        if (shorter_px <= large_box * bgr.rows) inner |= letters_in(ink, reach);
        cv::Mat letters;
        cv::dilate(inner, letters, cv::Mat::ones(5, 5, CV_8U));
        letters.setTo(0, ink & ~inner);
        part.setTo(cv::Scalar(ground[0], ground[1], ground[2]), letters);
    }
}

}  // namespace

Result<Found> find_lines_of_page(std::span<const std::byte> page, const TraceOptions& options,
                                 const cv::Mat1b& main_things) {
    const auto parts = decode::parts_of(page);
    if (!parts) return tl::unexpected(parts.error());
    if (parts->header.kind != decode::AnswerKind::page)
        return failure("there is no picture to find lines in");
    cv::Mat bgr = view_of(*parts);
    const std::span words(parts->boxes.data(), parts->header.boxes);
    if (!words.empty()) {
        bgr = bgr.clone();
        paint_over(bgr, words);
    }
    return find_lines(bgr, options, main_things);
}

cv::Mat view_of(const decode::AnswerParts& page) {
    return {static_cast<int>(page.header.height), static_cast<int>(page.header.width), CV_8UC3,
            const_cast<std::byte*>(page.pixels.data())};
}

}  // namespace touchline
