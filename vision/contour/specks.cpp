#include "vision/contour/specks.h"

#include "vision/contour/region_map.h"

#include <algorithm>
#include <array>

#include <opencv2/imgproc.hpp>

namespace touchline {
namespace {

constexpr int kLeastArea_px = 12;    // less is grain
constexpr double kClear = 40.0;      // grey levels to what lies around
constexpr double kClearPart = 0.25;  // of the strongest contrast in the picture
constexpr double kOfItself = 0.5;    // of the speck's contrast; less is its soft edge
constexpr int kMostSpecks = 2000;    // more are grain, or a tone that is printed in dots
constexpr std::size_t kColours = 256;

uchar commonest(const std::array<int, kColours>& counts) {
    return static_cast<uchar>(std::ranges::max_element(counts) - counts.begin());
}

double strongest_contrast(const std::vector<cv::Vec3f>& palette) {
    double strongest = 0.0;
    for (const cv::Vec3f& a : palette) {
        for (const cv::Vec3f& b : palette) {
            strongest = std::max(strongest, cv::norm(a - b));
        }
    }
    return strongest;
}

/// One speck: where it is, and the map before and after it was overgrown.
class Speck {
  public:
    Speck(const cv::Mat1i& labels, int label, const cv::Rect& box, const cv::Mat1b& before,
          const cv::Mat1b& after)
        : box_((box + cv::Size(2, 2) - cv::Point(1, 1)) & cv::Rect({}, labels.size())),
          mask_(labels(box_) == label),
          before_(before(box_)),
          after_(after(box_)) {}

    /// What all around it is of, where that is one colour.
    [[nodiscard]] bool lies_in_one() const {
        const uchar first = beneath();
        cv::Mat around;
        cv::dilate(mask_, around, cv::Mat::ones(3, 3, CV_8U));
        for (int y = 0; y < mask_.rows; ++y) {
            for (int x = 0; x < mask_.cols; ++x) {
                if (around.at<uchar>(y, x) != 0 && after_(y, x) != first) {
                    return false;
                }
            }
        }
        return true;
    }

    [[nodiscard]] uchar beneath() const {
        for (int y = 0; y < mask_.rows; ++y) {
            for (int x = 0; x < mask_.cols; ++x) {
                if (mask_(y, x) != 0) {
                    return after_(y, x);
                }
            }
        }
        return 0;
    }

    [[nodiscard]] uchar colour() const {
        std::array<int, kColours> counts{};
        for (int y = 0; y < mask_.rows; ++y) {
            for (int x = 0; x < mask_.cols; ++x) {
                counts[before_(y, x)] += mask_(y, x) != 0 ? 1 : 0;
            }
        }
        return commonest(counts);
    }

    /// Puts what is clearly of the speck back, in one colour.
    void put_back(const std::vector<cv::Vec3f>& palette, cv::Mat1b& map, cv::Mat1b& kept) const {
        const uchar own = colour();
        const cv::Vec3f& ground = palette[beneath()];
        const double least = kOfItself * cv::norm(palette[own] - ground);
        for (int y = 0; y < mask_.rows; ++y) {
            for (int x = 0; x < mask_.cols; ++x) {
                if (mask_(y, x) != 0 && cv::norm(palette[before_(y, x)] - ground) >= least) {
                    map(box_.tl() + cv::Point(x, y)) = own;
                    kept(box_.tl() + cv::Point(x, y)) = 255;
                }
            }
        }
    }

  private:
    cv::Rect box_;
    cv::Mat1b mask_;
    cv::Mat1b before_;
    cv::Mat1b after_;
};

}  // namespace

cv::Mat1b without_specks(cv::Mat1b& map, const std::vector<cv::Vec3f>& palette, int least_px) {
    const cv::Mat1b before = map.clone();
    overgrow_specks(map, least_px);
    const cv::Mat1b after = map.clone();
    cv::Mat1b kept(map.size(), uchar{0});
    cv::Mat1i labels;
    cv::Mat1i stats;
    cv::Mat1d centres;
    const int n =
        cv::connectedComponentsWithStats(before != after, labels, stats, centres, 8, CV_32S);
    const double clear = std::max(kClear, kClearPart * strongest_contrast(palette));
    std::vector<Speck> specks;
    for (int i = 1; i < n; ++i) {
        if (stats(i, cv::CC_STAT_AREA) < kLeastArea_px) {
            continue;
        }
        const cv::Rect box(stats(i, cv::CC_STAT_LEFT), stats(i, cv::CC_STAT_TOP),
                           stats(i, cv::CC_STAT_WIDTH), stats(i, cv::CC_STAT_HEIGHT));
        Speck speck(labels, i, box, before, after);
        if (cv::norm(palette[speck.colour()] - palette[speck.beneath()]) >= clear &&
            speck.lies_in_one()) {
            specks.push_back(std::move(speck));
        }
    }
    if (specks.size() <= kMostSpecks) {
        for (const Speck& speck : specks) {
            speck.put_back(palette, map, kept);
        }
    }
    return kept;
}

}  // namespace touchline
