#include "vision/contour/gradient.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

// Low, because in a dense pattern most second differences are edges.
constexpr double noise_quantile = 0.25;
constexpr double quantile_to_sigma = 1.0 / 0.31864;  // of a normal distribution
constexpr double laplacian_gain = 6.0;               // root of the kernel's summed squares: 36
constexpr float grey_levels_per_l = 2.55F;           // L runs 0..100

/// Converts sRGB to CIE Lab (D65) for 8-bit input. OpenCV's own conversion takes 0.2 s of every
/// process to build its tables.
class LabTables {
  public:
    LabTables() {
        for (std::size_t i = 0; i < linear_.size(); ++i) {
            const double v = static_cast<double>(i) / 255.0;
            linear_[i] =
                static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
        }
        for (std::size_t i = 0; i < root_.size(); ++i) {
            const double t = static_cast<double>(i) / root_steps;
            root_[i] = static_cast<float>(
                t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0);
        }
    }

    cv::Vec3f lab_of(uchar red, uchar green, uchar blue) const {
        const float r = linear_[red];
        const float g = linear_[green];
        const float b = linear_[blue];
        const float fx = root((0.412453F * r + 0.357580F * g + 0.180423F * b) / 0.950456F);
        const float fy = root(0.212671F * r + 0.715160F * g + 0.072169F * b);
        const float fz = root((0.019334F * r + 0.119193F * g + 0.950227F * b) / 1.088754F);
        return {grey_levels_per_l * (116.0F * fy - 16.0F), 500.0F * (fx - fy), 200.0F * (fy - fz)};
    }

  private:
    static constexpr int root_steps = 4096;

    /// Interpolates linearly in the table, t in 0..1.
    float root(float t) const {
        const float at = std::clamp(t, 0.0F, 1.0F) * root_steps;
        const auto i = std::min<std::size_t>(root_steps - 1, static_cast<std::size_t>(at));
        const float part = at - static_cast<float>(i);
        return root_[i] + part * (root_[i + 1] - root_[i]);
    }

    std::array<float, 256> linear_{};
    std::array<float, root_steps + 1> root_{};
};

}  // namespace

cv::Mat reduced(const cv::Mat& picture, double max_pixels) {
    const double pixels = static_cast<double>(picture.cols) * picture.rows;
    if (pixels <= max_pixels) return picture;
    const double scale = std::sqrt(max_pixels / pixels);
    const cv::Size size(std::max(1, static_cast<int>(picture.cols * scale)),
                        std::max(1, static_cast<int>(picture.rows * scale)));
    cv::Mat small;
    cv::resize(picture, small, size, 0.0, 0.0, cv::INTER_AREA);
    return small;
}

LabPicture to_lab(const cv::Mat& bgr_or_grey, float colour_weight) {
    static const LabTables tables;
    const bool is_grey = bgr_or_grey.channels() == 1;
    LabPicture lab(bgr_or_grey.size());
    for (int y = 0; y < lab.rows; ++y) {
        const uchar* from = bgr_or_grey.ptr<uchar>(y);
        for (int x = 0; x < lab.cols; ++x) {
            const uchar* p = is_grey ? from + x : from + 3 * x;
            const cv::Vec3f v =
                is_grey ? tables.lab_of(*p, *p, *p) : tables.lab_of(p[2], p[1], p[0]);
            lab(y, x) = {v[0], colour_weight * v[1], colour_weight * v[2]};
        }
    }
    return lab;
}

double noise_of(const LabPicture& lab) {
    if (lab.cols < 3 || lab.rows < 3) return 0.0;
    const cv::Matx33f kernel(1, -2, 1, -2, 4, -2, 1, -2, 1);
    cv::Mat3f second;
    cv::filter2D(lab, second, CV_32F, kernel);
    double variance = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        cv::Mat1f one;
        cv::extractChannel(second, one, channel);
        one = cv::abs(one);
        const double sigma =
            quantile_to_sigma * static_cast<double>(quantile(one, noise_quantile)) / laplacian_gain;
        variance += sigma * sigma;
    }
    return std::sqrt(variance);
}

double gradient_noise(double noise, double sigma_px) {
    return noise / (std::sqrt(8.0 * std::numbers::pi) * sigma_px * sigma_px);
}

cv::Vec2f major_axis(float xx, float yy, float xy) {
    const float difference = xx - yy;
    const float root = std::sqrt(difference * difference + 4.0F * xy * xy);
    if (!(root > 0.0F)) return {1.0F, 0.0F};
    const float cos_twice = difference / root;
    const float cosine = std::sqrt(std::max(0.0F, 0.5F * (1.0F + cos_twice)));
    const float sine = std::sqrt(std::max(0.0F, 0.5F * (1.0F - cos_twice)));
    return {cosine, std::copysign(sine, xy)};
}

GradientField colour_gradient(const LabPicture& lab, double sigma_px) {
    LabPicture smooth;
    cv::GaussianBlur(lab, smooth, cv::Size(), sigma_px, sigma_px, cv::BORDER_REPLICATE);
    GradientField field{cv::Mat1f(lab.size()), cv::Mat2f(lab.size())};
    const int last_x = lab.cols - 1;
    const int last_y = lab.rows - 1;
    for (int y = 0; y <= last_y; ++y) {
        const cv::Vec3f* above = smooth[std::max(0, y - 1)];
        const cv::Vec3f* here = smooth[y];
        const cv::Vec3f* below = smooth[std::min(last_y, y + 1)];
        for (int x = 0; x <= last_x; ++x) {
            const cv::Vec3f dx = 0.5F * (here[std::min(last_x, x + 1)] - here[std::max(0, x - 1)]);
            const cv::Vec3f dy = 0.5F * (below[x] - above[x]);
            const float xx = dx.dot(dx);
            const float yy = dy.dot(dy);
            const float xy = dx.dot(dy);
            const float root = std::sqrt((xx - yy) * (xx - yy) + 4.0F * xy * xy);
            const cv::Vec2f across = major_axis(xx, yy, xy);
            const cv::Vec2f rise(dx[0] + dx[1] + dx[2], dy[0] + dy[1] + dy[2]);
            field.strength(y, x) = std::sqrt(0.5F * (xx + yy + root));
            field.normal(y, x) = rise.dot(across) < 0.0F ? -across : across;
        }
    }
    return field;
}

float quantile(const cv::Mat1f& values, double fraction) {
    constexpr std::size_t sample_count = 250000;
    const std::size_t step = std::max<std::size_t>(1, values.total() / sample_count);
    std::vector<float> sample;
    sample.reserve(values.total() / step + 1);
    std::size_t next = 0;
    std::size_t index = 0;
    for (const float value : values) {
        if (index++ == next) {
            sample.push_back(value);
            next += step;
        }
    }
    return sample.empty() ? 0.0F : quantile(std::move(sample), fraction);
}

}  // namespace touchline
