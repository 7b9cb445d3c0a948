#include "vision/contour/region_map.h"

#include "vision/contour/palette.h"
#include "vision/contour/region_runs.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace touchline {
namespace {

constexpr int kReach_px = 3;       // how far away to look for the pure colours beside an edge
constexpr float kMixture = 14.0F;  // grey levels off the line between two colours
constexpr float kMixtureOverStep = 0.12F;

/// Returns the pixels whose neighbours all have the same colour.
cv::Mat1b uniform_pixels(const cv::Mat1b& colours) {
    cv::Mat1b uniform(colours.size(), uchar{0});
    for (int y = 1; y + 1 < colours.rows; ++y) {
        for (int x = 1; x + 1 < colours.cols; ++x) {
            const uchar c = colours(y, x);
            bool same = true;
            for (int j = -1; j <= 1 && same; ++j) {
                same = colours(y + j, x - 1) == c && colours(y + j, x) == c &&
                       colours(y + j, x + 1) == c;
            }
            uniform(y, x) = same ? 255 : 0;
        }
    }
    return uniform;
}

bool is_solid(const cv::Mat1b& colours, const cv::Mat1b& uniform, int y, int x) {
    for (int v = std::max(0, y - 1); v <= std::min(colours.rows - 1, y + 1); ++v) {
        for (int u = std::max(0, x - 1); u <= std::min(colours.cols - 1, x + 1); ++u) {
            if (uniform(v, u) != 0 && colours(v, u) == colours(y, x)) {
                return true;
            }
        }
    }
    return false;
}

/// Undoes the false colours along edges.
class Mixtures {
  public:
    Mixtures(const LabPicture& lab, const std::vector<cv::Vec3f>& palette, const cv::Mat1b& colours)
        : lab_(lab), palette_(palette), colours_(colours), uniform_(uniform_pixels(colours)) {}

    [[nodiscard]] cv::Mat1b undone() const {
        cv::Mat1b map = colours_.clone();
        for (int y = 0; y < map.rows; ++y) {
            for (int x = 0; x < map.cols; ++x) {
                if (uniform_(y, x) == 0 && !is_solid(colours_, uniform_, y, x)) {
                    map(y, x) = true_colour(y, x);
                }
            }
        }
        return map;
    }

  private:
    /// Looks at the colours nearby, each with how well a pixel there shows it.
    [[nodiscard]] uchar true_colour(int y, int x) const {
        std::array<uchar, 8> near{};
        std::size_t n = 0;
        const uchar own = colours_(y, x);
        for (int v = std::max(0, y - kReach_px); v <= std::min(lab_.rows - 1, y + kReach_px); ++v) {
            for (int u = std::max(0, x - kReach_px); u <= std::min(lab_.cols - 1, x + kReach_px);
                 ++u) {
                const uchar c = colours_(v, u);
                const bool is_new =
                    c != own && std::find(near.begin(), near.begin() + n, c) == near.begin() + n;
                if (is_new && n < near.size() && is_pure(v, u)) {
                    near[n++] = c;
                }
            }
        }
        return best_mixture(lab_(y, x), own, {near.begin(), near.begin() + n});
    }

    [[nodiscard]] bool is_pure(int y, int x) const {
        const cv::Vec3f d = lab_(y, x) - palette_[colours_(y, x)];
        return uniform_(y, x) != 0 || d.dot(d) < kMixture * kMixture;
    }

    [[nodiscard]] uchar best_mixture(const cv::Vec3f& colour, uchar own,
                                     const std::vector<uchar>& near) const {
        uchar best = own;
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < near.size(); ++i) {
            for (std::size_t j = i + 1; j < near.size(); ++j) {
                const cv::Vec3f& a = palette_[near[i]];
                const cv::Vec3f step = palette_[near[j]] - a;
                const float t = (colour - a).dot(step) / step.dot(step);
                const cv::Vec3f off = colour - a - std::clamp(t, 0.0F, 1.0F) * step;
                const float limit =
                    std::max(kMixture, kMixtureOverStep * std::sqrt(step.dot(step)));
                if (off.dot(off) < std::min(limit * limit, least)) {
                    least = off.dot(off);
                    best = near[t < 0.5F ? i : j];
                }
            }
        }
        return best;
    }

    const LabPicture& lab_;
    const std::vector<cv::Vec3f>& palette_;
    const cv::Mat1b& colours_;
    cv::Mat1b uniform_;
};

/// Returns the runs of regions below `least_px`; none if there are no others.
std::vector<Run> small_regions(const cv::Mat1b& map, int least_px) {
    const std::vector<Run> runs = runs_of(map);
    std::vector<int> area_px(runs.size(), 0);
    for (const Run& run : runs) {
        area_px[run.region] += run.to - run.from;
    }
    std::vector<Run> small;
    std::ranges::copy_if(runs, std::back_inserter(small),
                         [&](const Run& run) { return area_px[run.region] < least_px; });
    return small.size() < runs.size() ? small : std::vector<Run>();
}

std::array<cv::Point, 4> beside(const cv::Point& p) {
    return {cv::Point(p.x, p.y - 1), {p.x - 1, p.y}, {p.x + 1, p.y}, {p.x, p.y + 1}};
}

}  // namespace

cv::Mat1b region_map(const LabPicture& lab, const std::vector<cv::Vec3f>& palette) {
    return Mixtures(lab, palette, nearest_colours(lab, palette)).undone();
}

void overgrow_specks(cv::Mat1b& map, int least_px) {
    cv::Mat1b gone(map.size(), uchar{0});
    for (const Run& run : small_regions(map, least_px)) {
        gone(cv::Rect(run.from, run.row, run.to - run.from, 1)) = 255;
    }
    overgrow(map, gone);
}

void overgrow(cv::Mat1b& map, const cv::Mat1b& mask) {
    cv::Mat1b gone = mask.clone();
    const cv::Rect frame({}, map.size());
    std::vector<cv::Point> front;
    for (int y = 0; y < map.rows; ++y) {
        for (int x = 0; x < map.cols; ++x) {
            const auto is_left = [&](const cv::Point& q) {
                return frame.contains(q) && gone(q) == 0;
            };
            if (gone(y, x) != 0) {
                std::ranges::copy_if(beside({x, y}), std::back_inserter(front), is_left);
            }
        }
    }
    for (std::size_t i = 0; i < front.size(); ++i) {
        const cv::Point p = front[i];
        for (const cv::Point& q : beside(p)) {
            if (frame.contains(q) && gone(q) != 0) {
                gone(q) = 0;
                map(q) = map(p);
                front.push_back(q);
            }
        }
    }
}

}  // namespace touchline
