// figures_bench PICTURES TRUTHS WAY [EACH]: looks for the main things of photographs, where
// somebody has marked them, in one way: the network "figure" at a size (a number: pixels a side),
// the small network that ships ("small"), or colours alone ("grabcut",
// vision/contour/main_shape.h). PICTURES/NAME.jpg with PICTURES/NAME-human1.png
// ... (boundaries), TRUTHS/NAME.png (128 and more: the thing). Prints a row of CSV; the memory is
// that of this process. EACH gets a row more for each picture: way, name, overlap, ring on a
// boundary, contrast, felt ring on a boundary (as with_figure draws it).
// figures_bench --none PICTURES WAY: in pictures without a main thing; prints how many there are,
// in how many one is claimed, and in how many surely.
#include "vision/figure/figures.h"

#include "app/documents/models/networks.h"
#include "tests/lab/bench/vision/pictures.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/photo_lines.h"
#include "vision/contour/rings.h"
#include "vision/figure/figure_network.h"
#include "vision/figure/small_figure_network.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>
#include <sys/resource.h>

namespace touchline::bench {
namespace {

constexpr float near_px = 2.0F;
constexpr double sheet_mm = 116.0;  // of the longer side

struct Score {
    double overlap = 0.0;         // intersection over union
    double ring_precision = 0.0;  // of the ring, within two pixels of a boundary that somebody drew
    double felt_precision = 0.0;  // of the ring after it is drawn onto edges
    double ms = 0.0;
    double contrast = 0.0;
    bool is_sure = false;
};

cv::Mat at_size(const cv::Mat1b& mask, cv::Size size) {
    cv::Mat fitted;
    cv::resize(mask, fitted, size);
    return fitted >= 128;
}

double overlap_of(const cv::Mat& found, const cv::Mat& truth) {
    return static_cast<double>(cv::countNonZero(found & truth)) /
           std::max(1, cv::countNonZero(found | truth));
}

/// Returns the share of some places that lie near a boundary which somebody drew. Places on the
/// picture's frame do not count: they are not a boundary of anything.
double near_share(const std::vector<cv::Point2d>& places, const std::vector<cv::Mat1b>& annotators,
                  cv::Size size) {
    cv::Mat1b free(size, uchar{255});
    for (const cv::Mat1b& boundary : annotators) free.setTo(0, boundary);
    cv::Mat1f distance;
    cv::distanceTransform(free, distance, cv::DIST_L2, 5);
    int near = 0;
    int all = 0;
    const cv::Rect inner(2, 2, size.width - 4, size.height - 4);
    for (const cv::Point2d& place : places) {
        const cv::Point at(cvRound(place.x), cvRound(place.y));
        if (!inner.contains(at)) continue;
        ++all;
        near += distance(at) <= near_px ? 1 : 0;
    }
    return static_cast<double>(near) / std::max(1, all);
}

std::vector<cv::Point2d> rings_of(const cv::Mat& found) {
    cv::Mat1f soft;
    found.convertTo(soft, CV_32F);
    std::vector<cv::Point2d> places;
    for (const Chain& ring : iso_rings(soft, 127.5F)) {
        for (const EdgePoint& p : ring.points) places.push_back(p.at);
    }
    return places;
}

/// Returns the places of the rings that a hand is given, in the picture's pixels.
std::vector<cv::Point2d> felt_rings_of(const cv::Mat3b& picture, const cv::Mat1b& mask) {
    const PhotoLines lines = with_figure(photo_lines(picture, sheet_mm), picture, mask, sheet_mm);
    const cv::Point2d scale(static_cast<double>(picture.cols) / lines.size.width,
                            static_cast<double>(picture.rows) / lines.size.height);
    std::vector<cv::Point2d> places;
    for (const Chain& line : lines.chains) {
        if (line.of != LineOf::ring) continue;
        for (const EdgePoint& p : line.points) {
            places.emplace_back(scale.x * (p.at.x + 0.5) - 0.5, scale.y * (p.at.y + 0.5) - 0.5);
        }
    }
    return places;
}

/// Finds the main things of a picture.
using Way = std::function<Result<Figures>(const cv::Mat3b&)>;

Result<Score> score_of(const MarkedPicture& picture, const cv::Mat& truth, const Way& way) {
    const auto begin = std::chrono::steady_clock::now();
    const auto figures = way(picture.picture);
    if (!figures) return tl::unexpected(figures.error());
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    const cv::Size size = picture.picture.size();
    const cv::Mat found = at_size(figures->mask, size);
    const auto felt = felt_rings_of(picture.picture, figures->mask);
    return Score{overlap_of(found, truth),
                 near_share(rings_of(found), picture.annotators, size),
                 near_share(felt, picture.annotators, size),
                 took.count(),
                 figures->signs.contrast,
                 figures->is_sure};
}

Figures figures_by_colours(const cv::Mat3b& picture) {
    Figures figures;
    figures.mask = cv::Mat1b(picture.size(), uchar{0});
    const auto shape = main_shape(picture, std::nullopt);
    if (!shape) return figures;
    std::vector<cv::Point> corners;
    for (const EdgePoint& p : shape->points) corners.emplace_back(cvRound(p.at.x), cvRound(p.at.y));
    cv::fillPoly(figures.mask, std::vector{corners}, cv::Scalar(255));
    figures.is_sure = true;
    return figures;
}

/// A network lives as long as the way that holds it.
template <class Network, class Likelihood>
Result<Way> way_with(std::string_view name, Likelihood likelihood) {
    const auto bytes = read_network(*network_named(name));
    if (!bytes) return tl::unexpected(bytes.error());
    auto network = Network::from_onnx(*bytes);
    if (!network) return tl::unexpected(network.error());
    const auto kept = std::make_shared<Network>(std::move(*network));
    return Way([kept, likelihood](const cv::Mat3b& picture) {
        return likelihood(*kept, picture).map([&](const cv::Mat1f& likely) {
            return figures_of(likely, picture.size());
        });
    });
}

Result<Way> way_of(const std::string& name) {
    if (name == "grabcut") return Way(figures_by_colours);
    if (name == "small")
        return way_with<SmallFigureNetwork>(
            "small-figure", [](SmallFigureNetwork& network, const cv::Mat3b& picture) {
                return network.likelihood(picture);
            });
    const int side_px = std::atoi(name.c_str());
    return way_with<FigureNetwork>("figure",
                                   [side_px](FigureNetwork& network, const cv::Mat3b& picture) {
                                       return network.likelihood(picture, side_px);
                                   });
}

double middle(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

template <class Value>
double mean(const std::vector<Score>& scores, Value value) {
    double sum = 0.0;
    for (const Score& score : scores) sum += value(score);
    return scores.empty() ? 0.0 : sum / static_cast<double>(scores.size());
}

void print(const std::string& way, const std::vector<Score>& scores) {
    std::vector<Score> sure;
    std::vector<Score> others;
    std::vector<double> overlaps;
    std::vector<double> times;
    for (const Score& score : scores) {
        (score.is_sure ? sure : others).push_back(score);
        overlaps.push_back(score.overlap);
        times.push_back(score.ms);
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto overlap = [](const Score& score) { return score.overlap; };
    const auto precision = [](const Score& score) { return score.ring_precision; };
    const auto felt = [](const Score& score) { return score.felt_precision; };
    std::printf("%s,%zu,%.3f,%.3f,%zu,%.3f,%.3f,%.0f,%ld,%.3f,%.3f\n", way.c_str(), scores.size(),
                mean(scores, overlap), middle(overlaps), sure.size(), mean(sure, precision),
                mean(others, precision), middle(times), usage.ru_maxrss / 1024, mean(sure, felt),
                mean(others, felt));
}

Result<void> measure(const std::string& pictures, const std::string& truths,
                     const std::string& name, const std::string& each) {
    const auto marked = pictures_in(pictures, truths);
    if (!marked) return tl::unexpected(marked.error());
    const auto way = way_of(name);
    if (!way) return tl::unexpected(way.error());
    std::vector<Score> scores;
    std::ofstream rows(each, std::ios::app);
    for (const FigurePicture& picture : *marked) {
        const auto score = score_of(picture.marked, picture.truth >= 128, *way);
        if (!score) return tl::unexpected(score.error());
        scores.push_back(*score);
        rows << name << ',' << picture.name << ',' << score->overlap << ',' << score->ring_precision
             << ',' << score->contrast << ',' << score->felt_precision << '\n';
    }
    print(name, scores);
    return {};
}

/// Counts in how many pictures without a main thing one is claimed.
Result<void> measure_none(const std::string& folder, const std::string& name) {
    const auto pictures = bare_pictures_in(folder);
    if (!pictures) return tl::unexpected(pictures.error());
    const auto way = way_of(name);
    if (!way) return tl::unexpected(way.error());
    int claimed = 0;
    int sure = 0;
    for (const cv::Mat& picture : *pictures) {
        const auto figures = (*way)(picture);
        if (!figures) return tl::unexpected(figures.error());
        claimed += cv::countNonZero(figures->mask >= 128) > 0 ? 1 : 0;
        sure += figures->is_sure ? 1 : 0;
    }
    std::printf("%s,%zu,%d,%d\n", name.c_str(), pictures->size(), claimed, sure);
    return {};
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc < 4 || argc > 5) {
        std::fputs("usage: figures_bench PICTURES TRUTHS WAY [EACH] | --none PICTURES WAY\n",
                   stderr);
        return 2;
    }
    const bool is_none = std::string(argv[1]) == "--none";
    const auto done =
        is_none ? touchline::bench::measure_none(argv[2], argv[3])
                : touchline::bench::measure(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "");
    if (done) return 0;
    std::fprintf(stderr, "%s\n", done.error().line.c_str());
    return 1;
}
