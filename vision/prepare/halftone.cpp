#include "vision/prepare/halftone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int most_crop_px = 512;
constexpr int least_crop_px = 64;
constexpr double widest_pitch_px = 16.0;  // apart
constexpr double closest_pitch_px = 2.5;
constexpr int peak_steps = 2;        // steps of frequency round a peak that belong to it
constexpr double peak_share = 0.25;  // of the power at such frequencies, in both peaks
constexpr double overtone = 0.3;  // of its power: if more is at a half or a third of its frequency
constexpr double alike_pitch_share = 0.15;  // of the pitch
constexpr double least_angle = 40.0 * std::numbers::pi / 180.0;
constexpr double blur_over_pitch = 0.55;

/// Returns the power of each frequency of the picture's middle; frequency zero is in the middle of
/// the matrix.
cv::Mat1f spectrum(const cv::Mat& picture) {
    const int size = std::min({most_crop_px, picture.cols, picture.rows}) & ~1;
    const cv::Rect middle((picture.cols - size) / 2, (picture.rows - size) / 2, size, size);
    cv::Mat grey = picture(middle);
    if (grey.channels() == 3) cv::cvtColor(grey, grey, cv::COLOR_BGR2GRAY);
    cv::Mat1f values;
    grey.convertTo(values, CV_32F);
    values -= cv::mean(values)[0];
    cv::Mat1f window;
    cv::createHanningWindow(window, values.size(), CV_32F);
    cv::Mat waves;
    cv::dft(values.mul(window), waves, cv::DFT_COMPLEX_OUTPUT);
    cv::Mat1f power(values.size());
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const cv::Vec2f& wave = waves.at<cv::Vec2f>(y, x);
            power((y + size / 2) % size, (x + size / 2) % size) = wave.dot(wave);
        }
    }
    return power;
}

/// Waves that are as fast as dots.
class Waves {
  public:
    explicit Waves(const cv::Mat1f& power) : all_(power), power_(power.clone()) {
        for (int y = 0; y < size(); ++y) {
            for (int x = 0; x < size(); ++x) {
                if (!is_fast(of({x, y}))) power_(y, x) = 0.0F;
            }
        }
        whole_ = cv::sum(power_)[0];
    }

    [[nodiscard]] double whole() const { return whole_; }

    /// Returns waves per picture, across and down.
    [[nodiscard]] cv::Point2d strongest() const {
        cv::Point at;
        cv::minMaxLoc(power_, nullptr, nullptr, nullptr, &at);
        return of(at);
    }

    /// Removes a peak and its mirror image, and returns how strong both were.
    double taken(const cv::Point2d& wave) {
        double sum = 0.0;
        for (const double sign : {1.0, -1.0}) {
            cv::Mat1f peak = power_(around(sign * wave));
            sum += cv::sum(peak)[0];
            peak = 0.0F;
        }
        return sum;
    }

    /// Returns whether the wave is only the second or third of a slower one: of dots that a hand
    /// can tell apart, or of a pattern.
    [[nodiscard]] bool is_overtone(const cv::Point2d& wave) const {
        const double own = cv::sum(all_(around(wave)))[0];
        return std::ranges::any_of(std::array{2.0, 3.0}, [&](double times) {
            return cv::sum(all_(around(wave / times)))[0] > overtone * own;
        });
    }

    [[nodiscard]] double pitch_px(const cv::Point2d& wave) const { return size() / cv::norm(wave); }

  private:
    [[nodiscard]] int size() const { return power_.rows; }

    [[nodiscard]] cv::Rect around(const cv::Point2d& wave) const {
        const cv::Rect peak(cvRound(wave.x) + size() / 2 - peak_steps,
                            cvRound(wave.y) + size() / 2 - peak_steps, 2 * peak_steps + 1,
                            2 * peak_steps + 1);
        return peak & cv::Rect({}, power_.size());
    }

    [[nodiscard]] cv::Point2d of(const cv::Point& at) const {
        return cv::Point2d(at) - 0.5 * cv::Point2d(size(), size());
    }

    [[nodiscard]] bool is_fast(const cv::Point2d& wave) const {
        return cv::norm(wave) * widest_pitch_px >= size();
    }

    cv::Mat1f all_;
    cv::Mat1f power_;  // of the remaining fast ones
    double whole_ = 0.0;
};

bool are_across(const cv::Point2d& a, const cv::Point2d& b) {
    const double angle = std::abs(std::atan2(a.cross(b), a.dot(b)));
    return angle >= least_angle && angle <= std::numbers::pi - least_angle;
}

}  // namespace

double dot_pitch(const cv::Mat& picture) {
    if (std::min(picture.cols, picture.rows) < least_crop_px) return 0.0;
    Waves waves(spectrum(picture));
    const cv::Point2d first = waves.strongest();
    double share = waves.taken(first);
    const cv::Point2d second = waves.strongest();
    share += waves.taken(second);
    const double pitch = waves.pitch_px(first);
    const bool are_alike = std::abs(waves.pitch_px(second) / pitch - 1.0) <= alike_pitch_share;
    const bool are_dots = are_alike && are_across(first, second) && pitch >= closest_pitch_px &&
                          share >= peak_share * waves.whole() && !waves.is_overtone(first) &&
                          !waves.is_overtone(second);
    return are_dots ? pitch : 0.0;
}

cv::Mat without_dots(const cv::Mat& picture) {
    const double pitch = dot_pitch(picture);
    if (!(pitch > 0.0)) return picture;
    cv::Mat tones;
    cv::GaussianBlur(picture, tones, {}, blur_over_pitch * pitch);
    return tones;
}

}  // namespace touchline
