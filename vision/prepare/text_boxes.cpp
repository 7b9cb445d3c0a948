#include "vision/prepare/text_boxes.h"

#include "config/types/groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int least_height_px = 4;
constexpr double greatest_height = 0.12;      // of the picture's height: larger marks are no text
constexpr double longest_over_height = 14.0;  // of one mark: letters of a word may touch
constexpr double gap_over_height = 1.6;       // between marks of one line
constexpr double height_ratio = 2.6;          // a capital beside a small letter
constexpr double overlap_share = 0.45;        // of the heights of neighbours
constexpr double off_base = 0.17;             // of the letter height: on the base line
constexpr double on_base = 0.62;              // part of the marks that are
constexpr int least_marks = 3;
constexpr double figure_part = 0.0015;  // of the picture: smaller boxes are specks

struct Mark {
    cv::Rect box;
    int area_px = 0;
};

std::vector<Mark> marks_of(const cv::Mat1b& mask) {
    cv::Mat labels;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8, CV_32S);
    std::vector<Mark> marks;
    for (int i = 1; i < n; ++i) {
        marks.push_back({{stats(i, cv::CC_STAT_LEFT), stats(i, cv::CC_STAT_TOP),
                          stats(i, cv::CC_STAT_WIDTH), stats(i, cv::CC_STAT_HEIGHT)},
                         stats(i, cv::CC_STAT_AREA)});
    }
    return marks;
}

bool may_be_letters(const Mark& mark, const cv::Size& page) {
    return mark.box.height >= least_height_px && mark.box.height <= greatest_height * page.height &&
           mark.box.width <= longest_over_height * mark.box.height && mark.area_px >= 6;
}

bool are_neighbours(const cv::Rect& a, const cv::Rect& b) {
    const int low = std::min(a.height, b.height);
    const int high = std::max(a.height, b.height);
    const int overlap = std::min(a.br().y, b.br().y) - std::max(a.y, b.y);
    const int gap = std::max(a.x, b.x) - std::min(a.br().x, b.br().x);
    return high <= height_ratio * low && overlap >= overlap_share * low &&
           gap <= gap_over_height * high;
}

Groups lines_among(const std::vector<Mark>& letters) {
    Groups groups(letters.size());
    std::vector<std::size_t> order(letters.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return letters[i].box.x; });
    int widest = 0;
    int tallest = 0;
    for (const Mark& mark : letters) {
        widest = std::max(widest, mark.box.width);
        tallest = std::max(tallest, mark.box.height);
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
        const cv::Rect& here = letters[order[k]].box;
        const int reach = here.br().x + static_cast<int>(gap_over_height * tallest);
        for (std::size_t j = k + 1; j < order.size() && letters[order[j]].box.x <= reach; ++j) {
            if (are_neighbours(here, letters[order[j]].box)) groups.join(order[k], order[j]);
        }
    }
    return groups;
}

/// Returns whether most marks stand on one straight line, whose slope is the median between marks
/// that are some way apart.
bool stand_on_base_line(const std::vector<Mark>& marks) {
    std::vector<double> heights;
    std::vector<double> slopes;
    for (const Mark& mark : marks) heights.push_back(mark.box.height);
    const double height = median_of(heights);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        for (std::size_t j = i + 1; j < marks.size() && slopes.size() < 4000; ++j) {
            const double run = marks[j].box.x - marks[i].box.x;
            if (std::abs(run) > 3.0 * height) {
                slopes.push_back((marks[j].box.br().y - marks[i].box.br().y) / run);
            }
        }
    }
    const double slope = slopes.empty() ? 0.0 : median_of(slopes);
    std::vector<double> bases;
    for (const Mark& mark : marks) bases.push_back(mark.box.br().y - slope * mark.box.x);
    const double base = median_of(bases);
    const auto standing = std::ranges::count_if(
        bases, [&](double b) { return std::abs(b - base) <= std::max(1.01, off_base * height); });
    return static_cast<double>(standing) >= on_base * static_cast<double>(marks.size());
}

/// Marks of one shape in a row are dots, dashes or tiles.
bool are_of_one_shape(const std::vector<Mark>& marks) {
    constexpr double same_size_share = 0.08;
    constexpr double most_alike_share = 0.9;  // the rest is cut off, or touches something
    std::vector<double> widths;
    std::vector<double> heights;
    std::vector<double> areas_px;
    for (const Mark& mark : marks) {
        widths.push_back(mark.box.width);
        heights.push_back(mark.box.height);
        areas_px.push_back(mark.area_px);
    }
    const double width = median_of(widths);
    const double height = median_of(heights);
    const double area_px = median_of(areas_px);
    const auto alike = std::ranges::count_if(marks, [&](const Mark& mark) {
        return std::abs(mark.box.width - width) <= std::max(1.0, same_size_share * width) &&
               std::abs(mark.box.height - height) <= std::max(1.0, same_size_share * height) &&
               std::abs(mark.area_px - area_px) <= 2.0 * same_size_share * area_px;
    });
    return static_cast<double>(alike) >= most_alike_share * static_cast<double>(marks.size());
}

void merge_overlapping(std::vector<cv::Rect>& boxes) {
    for (bool has_merged = true; has_merged;) {
        has_merged = false;
        for (std::size_t i = 0; i < boxes.size() && !has_merged; ++i) {
            for (std::size_t j = i + 1; j < boxes.size() && !has_merged; ++j) {
                if ((boxes[i] & boxes[j]).area() > 0) {
                    boxes[i] |= boxes[j];
                    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
                    has_merged = true;
                }
            }
        }
    }
}

}  // namespace

PageLayout page_layout(const Ink& ink) {
    const cv::Size page = ink.mask.size();
    std::vector<Mark> letters;
    std::vector<Mark> others;
    for (const Mark& mark : marks_of(ink.mask)) {
        (may_be_letters(mark, page) ? letters : others).push_back(mark);
    }
    constexpr std::size_t most_marks = 20000;  // with more it is grain, not a page
    if (letters.size() > most_marks) return {};
    Groups groups = lines_among(letters);
    std::vector<std::vector<Mark>> rows(letters.size());
    for (std::size_t i = 0; i < letters.size(); ++i) rows[groups.first_of(i)].push_back(letters[i]);
    PageLayout layout;
    for (const std::vector<Mark>& row : rows) {
        if (static_cast<int>(row.size()) >= least_marks && stand_on_base_line(row) &&
            !are_of_one_shape(row)) {
            TextLine line{row.front().box, static_cast<int>(row.size())};
            for (const Mark& mark : row) line.box |= mark.box;
            layout.lines.push_back(line);
        } else {
            others.insert(others.end(), row.begin(), row.end());
        }
    }
    std::vector<cv::Rect> rest;
    for (const Mark& mark : others) rest.push_back(mark.box);
    std::erase_if(rest, [&](const cv::Rect& box) {
        return box.area() < figure_part * page.area() || std::min(box.width, box.height) < 3;
    });
    merge_overlapping(rest);
    layout.figures = std::move(rest);
    std::ranges::sort(layout.lines, [](const TextLine& a, const TextLine& b) {
        return std::pair(a.box.y, a.box.x) < std::pair(b.box.y, b.box.x);
    });
    return layout;
}

}  // namespace touchline
