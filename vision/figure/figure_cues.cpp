#include "vision/figure/figure_cues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

using LabPicture = cv::Mat3f;  // L 0..255, a and b -128..127 + 128, as in 8 bits

LabPicture lab_of(const cv::Mat3b& picture) {
    cv::Mat3b smooth;
    cv::GaussianBlur(picture, smooth, cv::Size(3, 3), 0.0);
    cv::Mat3b lab;
    cv::cvtColor(smooth, lab, cv::COLOR_BGR2Lab);
    LabPicture values;
    lab.convertTo(values, CV_32F);
    return values;
}

/// Returns all places of a plane without gaps; far quicker than OpenCV's iterators.
template <class Value>
std::span<Value> places(cv::Mat_<Value>& plane) {
    return {plane[0], plane.total()};
}

template <class Value>
std::span<const Value> places(const cv::Mat_<Value>& plane) {
    return {plane[0], plane.total()};
}

float length(const cv::Vec3f& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Scales a plane so that its greatest value is 1; `least` keeps an even picture's noise small.
void scale_to_one(cv::Mat1f& plane, double least) {
    double greatest = 0.0;
    cv::minMaxLoc(plane, nullptr, &greatest);
    plane *= 1.0 / std::max(greatest, least);
}

/// Returns for one channel the least range of values on a way to the frame, by sweeps of the raster
/// (Zhang et al. 2015, "Minimum barrier salient object detection at 80 FPS").
class Barrier {
  public:
    explicit Barrier(cv::Mat1f channel)
        : values_(std::move(channel)),
          high_(values_.clone()),
          low_(values_.clone()),
          range_(values_.size(), std::numeric_limits<float>::infinity()) {
        range_.row(0) = 0.0F;
        range_.row(range_.rows - 1) = 0.0F;
        range_.col(0) = 0.0F;
        range_.col(range_.cols - 1) = 0.0F;
        sweep_down();
        sweep_up();
        sweep_down();
    }

    [[nodiscard]] const cv::Mat1f& range() const { return range_; }

  private:
    /// Goes on from the place before in a row, or in the row before, where that is better.
    struct Rows {
        const float* values;
        float* high;
        float* low;
        float* range;
    };

    Rows rows(int y) { return {values_[y], high_[y], low_[y], range_[y]}; }

    static void relax(const Rows& to, const Rows& from, int x, int from_x) {
        const float value = to.values[x];
        const float high = std::max(from.high[from_x], value);
        const float low = std::min(from.low[from_x], value);
        if (!(high - low < to.range[x])) return;
        to.range[x] = high - low;
        to.high[x] = high;
        to.low[x] = low;
    }

    void sweep_down() {
        for (int y = 1; y < values_.rows - 1; ++y) {
            const Rows to = rows(y);
            const Rows above = rows(y - 1);
            for (int x = 1; x < values_.cols - 1; ++x) {
                relax(to, above, x, x);
                relax(to, to, x, x - 1);
            }
        }
    }

    void sweep_up() {
        for (int y = values_.rows - 2; y > 0; --y) {
            const Rows to = rows(y);
            const Rows below = rows(y + 1);
            for (int x = values_.cols - 2; x > 0; --x) {
                relax(to, below, x, x);
                relax(to, to, x, x + 1);
            }
        }
    }

    cv::Mat1f values_;
    cv::Mat1f high_;  // on the best way known
    cv::Mat1f low_;
    cv::Mat1f range_;
};

cv::Mat1f barrier_plane(const LabPicture& lab) {
    constexpr double least = 24.0;
    cv::Mat1f sum(lab.size(), 0.0F);
    for (int channel = 0; channel < 3; ++channel) {
        cv::Mat1f values;
        cv::extractChannel(lab, values, channel);
        sum += Barrier(values).range();
    }
    scale_to_one(sum, least);
    return sum;
}

/// Returns how many deviations each place is away from the colours of a strip.
cv::Mat1f unlike(const LabPicture& lab, const cv::Rect& strip) {
    constexpr double noise = 20.0;  // squared; a strip of one colour has some too
    const cv::Mat3f colours = lab(strip).clone();
    cv::Matx33d covariance;
    cv::Matx13d mean;
    cv::calcCovarMatrix(colours.reshape(1, static_cast<int>(colours.total())), covariance, mean,
                        cv::COVAR_NORMAL | cv::COVAR_ROWS | cv::COVAR_SCALE, CV_64F);
    covariance = covariance + noise * cv::Matx33d::eye();
    cv::Matx33d axes;
    cv::Vec3d squares;
    cv::eigen(covariance, squares, axes);
    // Turns and stretches colours so that a deviation of the strip's is 1 on every axis.
    cv::Matx34f to_deviations;
    for (int row = 0; row < 3; ++row) {
        const double scale = 1.0 / std::sqrt(squares[row]);
        double shift = 0.0;
        for (int column = 0; column < 3; ++column) {
            to_deviations(row, column) = static_cast<float>(scale * axes(row, column));
            shift -= scale * axes(row, column) * mean(column);
        }
        to_deviations(row, 3) = static_cast<float>(shift);
    }
    cv::Mat3f deviations;
    cv::transform(lab, deviations, to_deviations);
    cv::Mat1f away(lab.size());
    std::ranges::transform(places(std::as_const(deviations)), places(away).begin(), length);
    return away;
}

/// Without the side that is least like a place: a thing may reach one side.
cv::Mat1f side_plane(const LabPicture& lab) {
    constexpr double least = 3.0;
    const int width = std::max(1, lab.cols / 14);
    const int height = std::max(1, lab.rows / 14);
    const std::array strips{
        cv::Rect(0, 0, lab.cols, height), cv::Rect(0, lab.rows - height, lab.cols, height),
        cv::Rect(0, 0, width, lab.rows), cv::Rect(lab.cols - width, 0, width, lab.rows)};
    cv::Mat1f sum(lab.size(), 0.0F);
    cv::Mat1f greatest(lab.size(), 0.0F);
    for (const cv::Rect& strip : strips) {
        cv::Mat1f away = unlike(lab, strip);
        scale_to_one(away, least);
        sum += away;
        greatest = cv::max(greatest, away);
    }
    sum -= greatest;
    scale_to_one(sum, 1.0);
    return sum;
}

cv::Mat1f unusual_plane(const LabPicture& lab) {
    constexpr double least = 30.0;
    const cv::Scalar means = cv::mean(lab);
    const cv::Vec3f mean(static_cast<float>(means[0]), static_cast<float>(means[1]),
                         static_cast<float>(means[2]));
    cv::Mat1f away(lab.size());
    std::ranges::transform(places(lab), places(away).begin(),
                           [&](const cv::Vec3f& colour) { return length(colour - mean); });
    scale_to_one(away, least);
    return away;
}

/// Where the pixels of each kind of colour lie: sums over them, and over those of like colours.
class ColourTable {
  public:
    struct Cell {
        float count = 0.0F;
        float x = 0.0F;  // of the picture's width, 0..1
        float y = 0.0F;
        float square = 0.0F;  // x * x + y * y
        float at_frame = 0.0F;

        void add(const Cell& other, float weight) {
            count += weight * other.count;
            x += weight * other.x;
            y += weight * other.y;
            square += weight * other.square;
            at_frame += weight * other.at_frame;
        }
    };

    explicit ColourTable(const LabPicture& lab) : cells_(cell_count) {
        const int margin_x = std::max(1, lab.cols / 28);
        const int margin_y = std::max(1, lab.rows / 28);
        const cv::Rect inner(margin_x, margin_y, lab.cols - 2 * margin_x, lab.rows - 2 * margin_y);
        for (int y = 0; y < lab.rows; ++y) {
            for (int x = 0; x < lab.cols; ++x) {
                const float across = static_cast<float>(x) / static_cast<float>(lab.cols);
                const float down = static_cast<float>(y) / static_cast<float>(lab.rows);
                cells_[place(lab(y, x))].add({1.0F, across, down, across * across + down * down,
                                              inner.contains({x, y}) ? 0.0F : 1.0F},
                                             1.0F);
            }
        }
        for (const std::size_t step : {std::size_t{1}, side, side * side}) soften(step);
    }

    /// Returns for each place a number of its colour's cell.
    template <class NumberOf>
    [[nodiscard]] cv::Mat1f plane(const LabPicture& lab, NumberOf number_of) const {
        std::vector<float> numbers(cell_count, 0.0F);
        std::ranges::transform(cells_, numbers.begin(), [&](const Cell& cell) {
            return cell.count > 0.0F ? number_of(cell) : 0.0F;
        });
        cv::Mat1f values(lab.size());
        std::ranges::transform(places(lab), places(values).begin(),
                               [&](const cv::Vec3f& colour) { return numbers[place(colour)]; });
        return values;
    }

  private:
    static constexpr std::size_t side = 24;
    static constexpr std::size_t cell_count = side * side * side;
    static constexpr float cell_width = 256.0F / side;

    static std::size_t place(const cv::Vec3f& colour) {
        std::size_t at = 0;
        for (int channel = 0; channel < 3; ++channel) {
            const auto cell = static_cast<std::size_t>(colour[channel] / cell_width);
            at = at * side + std::min(cell, side - 1);
        }
        return at;
    }

    /// Adds the neighbours on one axis, by 1 2 4 2 1.
    void soften(std::size_t step) {
        std::vector<Cell> soft(cell_count);
        for (std::size_t at = 0; at < cell_count; ++at) {
            if (cells_[at].count == 0.0F) continue;
            const std::size_t on_axis = at / step % side;
            for (std::size_t to = std::max<std::size_t>(on_axis, 2) - 2;
                 to <= std::min(on_axis + 2, side - 1); ++to) {
                const std::size_t apart = to > on_axis ? to - on_axis : on_axis - to;
                constexpr std::array weights{4.0F, 2.0F, 1.0F};
                soft[at + to * step - on_axis * step].add(cells_[at], weights[apart]);
            }
        }
        cells_ = std::move(soft);
    }

    std::vector<Cell> cells_;
};

float spread_of(const ColourTable::Cell& cell) {
    constexpr float even = 0.41F;  // of a colour that is everywhere
    const float x = cell.x / cell.count;
    const float y = cell.y / cell.count;
    const float variance = std::max(0.0F, cell.square / cell.count - x * x - y * y);
    return std::min(1.0F, std::sqrt(variance) / (1.25F * even));
}

float framed_of(const ColourTable::Cell& cell) {
    constexpr float share_of_frame = 0.138F;  // of all pixels, by the margins of the table
    return std::min(1.0F, cell.at_frame / cell.count / (3.0F * share_of_frame));
}

cv::Mat1f centre_plane(cv::Size size) {
    cv::Mat1f plane(size);
    const auto from_middle = [](int at, int size_px) {
        return 2.0F * (static_cast<float>(at) + 0.5F) / static_cast<float>(size_px) - 1.0F;
    };
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const float across = from_middle(x, size.width);
            const float down = from_middle(y, size.height);
            plane(y, x) = 0.5F * (across * across + down * down);
        }
    }
    return plane;
}

}  // namespace

std::array<cv::Mat1f, figure_cue_count> figure_cues(const cv::Mat3b& picture) {
    CV_Assert(picture.cols >= 16 && picture.rows >= 16);
    const LabPicture lab = lab_of(picture);
    const ColourTable table(lab);
    return {barrier_plane(lab),          side_plane(lab),
            unusual_plane(lab),          table.plane(lab, spread_of),
            table.plane(lab, framed_of), centre_plane(lab.size())};
}

}  // namespace touchline
