#include "vision/contour/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace touchline {
namespace {

constexpr int kBins = 32;       // along each axis
constexpr float kBin = 8.0F;    // grey levels
constexpr float kSame = 16.0F;  // colours nearer than this are one
constexpr std::size_t kMost = 64;
constexpr float kNear = 45.0F;  // a colour this near to a common one may be a ripple of it
constexpr double kLeastOverNear = 0.006;  // of the common colour's pixels
constexpr double kLeastInkPart = 0.0005;  // of the picture
constexpr float kFlat = 6.0F;             // grey levels across two pixels

struct Bin {
    cv::Vec3f sum;
    int count = 0;
};

int cell(float value, float low, float size, int n) {
    return static_cast<int>(std::clamp((value - low) / size, 0.0F, static_cast<float>(n - 1)));
}

float squared(const cv::Vec3f& d) {
    return d.dot(d);
}

std::size_t bin_of(const cv::Vec3f& lab) {
    return static_cast<std::size_t>(
        (cell(lab[0], 0.0F, kBin, kBins) * kBins + cell(lab[1], -128.0F, kBin, kBins)) * kBins +
        cell(lab[2], -128.0F, kBin, kBins));
}

/// Returns whether a pixel is not a mixture along an axis: both sides of it are alike, as in the
/// middle of a line, or it and one beside it are, as in a line of two pixels.
bool is_plain(const LabPicture& lab, const cv::Point& at, const cv::Point& along, float flat) {
    const auto alike = [&](int i, int j) {
        return squared(lab(at + i * along) - lab(at + j * along)) < flat * flat;
    };
    return alike(-1, 1) || (alike(0, 1) && alike(-1, 2)) || (alike(0, -1) && alike(1, -2));
}

/// Counts the colours of pixels that are not mixtures.
std::vector<Bin> histogram(const LabPicture& lab, double noise) {
    std::vector<Bin> bins(static_cast<std::size_t>(kBins * kBins * kBins));
    const float flat = kFlat + 3.0F * static_cast<float>(noise);
    for (int y = 2; y + 2 < lab.rows; ++y) {
        for (int x = 2; x + 2 < lab.cols; ++x) {
            if (is_plain(lab, {x, y}, {1, 0}, flat) && is_plain(lab, {x, y}, {0, 1}, flat)) {
                Bin& bin = bins[bin_of(lab(y, x))];
                bin.sum += lab(y, x);
                ++bin.count;
            }
        }
    }
    return bins;
}

/// Returns the mean of all filled bins within reach of `colour`.
Bin around(const std::vector<Bin>& filled, const cv::Vec3f& colour) {
    Bin all;
    for (const Bin& bin : filled) {
        if (squared(bin.sum * (1.0F / static_cast<float>(bin.count)) - colour) < kSame * kSame) {
            all.sum += bin.sum;
            all.count += bin.count;
        }
    }
    return all;
}

cv::Vec3f mean_of(const Bin& bin) {
    return bin.sum * (1.0F / static_cast<float>(bin.count));
}

/// Returns how many pixels make a colour: more near a common one, whose blur and compression look
/// like it.
double least_count(const Bin& peak, const std::vector<Bin>& found, double least) {
    double most = found.empty() ? 1.0 : std::max(1.0, least);
    for (const Bin& common : found) {
        if (peak.count > 0 && squared(mean_of(peak) - mean_of(common)) < kNear * kNear) {
            most = std::max(most, kLeastOverNear * common.count);
        }
    }
    return most;
}

}  // namespace

std::vector<cv::Vec3f> palette_of(const LabPicture& lab, double noise) {
    std::vector<Bin> filled = histogram(lab, noise);
    std::erase_if(filled, [](const Bin& bin) { return bin.count == 0; });
    if (filled.empty()) {
        return {lab(lab.rows / 2, lab.cols / 2)};
    }
    std::ranges::stable_sort(filled, std::greater<>(), &Bin::count);
    const double least = kLeastInkPart * static_cast<double>(lab.total());
    std::vector<Bin> found;
    while (!filled.empty() && found.size() < kMost) {
        Bin peak = around(filled, mean_of(filled.front()));
        peak = around(filled, mean_of(peak));  // one step uphill
        if (peak.count < least_count(peak, found, least)) {
            filled.erase(filled.begin());
            if (filled.empty() || filled.front().count < least / 16.0) {
                break;
            }
            continue;
        }
        const cv::Vec3f colour = mean_of(peak);
        found.push_back(peak);
        std::erase_if(
            filled, [&](const Bin& bin) { return squared(mean_of(bin) - colour) < kSame * kSame; });
    }
    std::vector<cv::Vec3f> palette;
    std::ranges::transform(found, std::back_inserter(palette), mean_of);
    return palette;
}

cv::Mat1b nearest_colours(const LabPicture& lab, const std::vector<cv::Vec3f>& palette) {
    constexpr int kFine = 64;          // cells along each axis: a table of the nearest, made as
    constexpr float kFineSize = 4.0F;  // asked for
    constexpr uchar kUnknown = 255;
    std::vector<uchar> table(static_cast<std::size_t>(kFine * kFine * kFine), kUnknown);
    cv::Mat1b nearest(lab.size());
    for (int y = 0; y < lab.rows; ++y) {
        for (int x = 0; x < lab.cols; ++x) {
            const cv::Vec3f& colour = lab(y, x);
            const int l = cell(colour[0], 0.0F, kFineSize, kFine);
            const int a = cell(colour[1], -128.0F, kFineSize, kFine);
            const int b = cell(colour[2], -128.0F, kFineSize, kFine);
            uchar& known = table[static_cast<std::size_t>((l * kFine + a) * kFine + b)];
            if (known == kUnknown) {
                const cv::Vec3f centre((static_cast<float>(l) + 0.5F) * kFineSize,
                                       (static_cast<float>(a) + 0.5F) * kFineSize - 128.0F,
                                       (static_cast<float>(b) + 0.5F) * kFineSize - 128.0F);
                const auto best = std::ranges::min_element(
                    palette, {}, [&](const cv::Vec3f& c) { return squared(c - centre); });
                known = static_cast<uchar>(best - palette.begin());
            }
            nearest(y, x) = known;
        }
    }
    return nearest;
}

}  // namespace touchline
