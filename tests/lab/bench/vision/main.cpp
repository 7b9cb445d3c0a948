// Accuracy against time: of detectors on marked pictures, of the whole way at several sizes.
#include "tests/lab/bench/vision/detectors.h"
#include "tests/lab/bench/vision/pictures.h"
#include "tests/vision/boundary/boundary_score.h"
#include "tests/vision/boundary/glyphs.h"
#include "tests/vision/boundary/line_truth.h"
#include "tests/vision/camera/frames.h"
#include "tests/vision/pictures/effects.h"
#include "vision/camera/frame.h"
#include "vision/contour/gradient.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/photo_lines.h"
#include "vision/prepare/picture_class.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/ostream.h>
#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

/// Processor milliseconds of one thread, over all runs.
struct StageTime {
    std::string stage;
    double least_ms = 0.0;
    double median_ms = 0.0;
};

constexpr std::int64_t working_pixels = 1'000'000;

cv::Mat3b generated() {
    cv::RNG random(3);
    cv::Mat3b coarse(60, 80);
    random.fill(coarse, cv::RNG::NORMAL, 150.0, 25.0);
    cv::Mat3b picture;
    cv::resize(coarse, picture, {4000, 3000}, 0.0, 0.0, cv::INTER_CUBIC);
    for (int i = 0; i < 25; ++i) {
        const cv::Point centre(random.uniform(300, 3700), random.uniform(300, 2700));
        const cv::Size size(random.uniform(80, 900), random.uniform(80, 700));
        cv::ellipse(
            picture, centre, size, random.uniform(0.0, 180.0), 0.0, 360.0,
            cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), random.uniform(0, 256)),
            cv::FILLED, cv::LINE_AA);
    }
    cv::GaussianBlur(picture, picture, {}, 2.0);
    cv::Mat3s noise(picture.size());
    random.fill(noise, cv::RNG::NORMAL, 0.0, 6.0);
    cv::add(picture, noise, picture, cv::noArray(), CV_8U);
    return picture;
}

/// Times of stages by name, in the order of their first run.
class Stages {
  public:
    template <class Stage>
    auto time(const std::string& name, const Stage& stage) {
        const std::clock_t start = std::clock();
        auto result = stage();
        const double passed_ms =
            1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        auto known = std::ranges::find(stages_, name, &Times::name);
        if (known == stages_.end()) {
            known = stages_.insert(stages_.end(), {name, {}});
        }
        known->ms.push_back(passed_ms);
        return result;
    }

    std::vector<StageTime> all() {
        std::vector<StageTime> result;
        for (Times& stage : stages_) {
            std::ranges::sort(stage.ms);
            result.push_back({stage.name, stage.ms.front(), stage.ms[stage.ms.size() / 2]});
        }
        return result;
    }

  private:
    struct Times {
        std::string name;
        std::vector<double> ms;
    };

    std::vector<Times> stages_;
};

cv::Mat decoded(const CameraFrame& still) {
    return to_bgr(still, quick_size(still.size, working_pixels)).value();
}

/// Makes a still of 12 megapixels, shapes before a rough background, as a JPEG of quality 90 as a
/// USB camera sends it. Decodes it, classes it, finds its lines and simplifies them at each detail.
/// The last row is the whole way at once. Needs at least one run.
std::vector<StageTime> still_stages(int runs) {
    const CameraFrame still = testing::mjpeg_frame(generated(), 90);
    Stages stages;
    for (int run = 0; run < runs; ++run) {
        const cv::Mat small =
            stages.time("JPEG decoded at a quarter", [&] { return decoded(still); });
        stages.time("what kind of picture", [&] { return class_of(small); });
        stages.time("a photo's lines", [&] { return photo_lines(small, 112.0); });
        stages.time("a photo's main shape", [&] { return main_shape(small, std::nullopt); });
        const Found found = find_lines(small, {}).value();
        for (int detail = 1; detail <= 5; ++detail) {
            stages.time(fmt::format("simplified to detail {}", detail),
                        [&] { return trace_lines(found, {.area = {}, .detail = detail}); });
        }
        stages.time("all: JPEG to map at detail 3",
                    [&] { return trace_outlines(decoded(still), {}); });
    }
    return stages.all();
}

using testing::boundary_counts;
using testing::BoundaryCounts;
using testing::BoundarySweep;

constexpr int stage_runs = 21;

double cpu_ms() {
    return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Returns the processor time of one call, the least of three; other programs do not count.
template <class Call>
double ms_of(Call&& call) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double before = cpu_ms();
        call();
        least = std::min(least, cpu_ms() - before);
    }
    return least;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void score(const std::string& set, const std::vector<MarkedPicture>& pictures, std::ofstream& csv) {
    for (const Detector& detector : detectors()) {
        BoundaryCounts automatic;
        BoundarySweep sweep;
        std::vector<double> times;
        for (const MarkedPicture& marked : pictures) {
            cv::Mat1b kept;
            times.push_back(ms_of([&] { kept = detector.automatic(marked.picture); }));
            automatic += boundary_counts(kept, BoundarySweep::automatic_level, marked.annotators);
            sweep.add(detector.ranked(marked.picture), marked.annotators);
        }
        fmt::print(csv, "{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.1f}\n", set, detector.name,
                   detector.setting, automatic.f(), automatic.precision(), automatic.recall(),
                   sweep.best().f(), median(times));
        csv.flush();
    }
}

/// Measures how much of the automatic lines stays under other light, noise, JPEG and blur.
void score_repeats(const std::string& set, const std::vector<MarkedPicture>& pictures,
                   std::ofstream& csv) {
    std::vector<std::pair<std::string, BoundaryCounts>> counts;
    for (const MarkedPicture& marked : pictures) {
        const auto lines = [](const cv::Mat& picture) {
            return cv::Mat1b(photo_lines(picture, 116.0).edge_strength);
        };
        const std::vector<cv::Mat1b> before{testing::thinned(
            cv::Mat1b(cv::Mat(lines(marked.picture) >= BoundarySweep::automatic_level)))};
        const std::vector<testing::Degraded> versions = testing::degraded(marked.picture);
        counts.resize(versions.size());
        for (std::size_t i = 0; i < versions.size(); ++i) {
            counts[i].first = versions[i].name;
            counts[i].second +=
                boundary_counts(lines(versions[i].picture), BoundarySweep::automatic_level, before);
        }
    }
    for (const auto& [name, count] : counts) {
        fmt::print(csv, "{},{},{:.3f}\n", set, name, count.f());
    }
}

/// Traces letters, as a camera of 3 megapixels gives them, at several working sizes.
void score_sizes(std::ofstream& csv) {
    const cv::Size full(2000, 1500);
    constexpr double shown_width_mm = 112.0;
    for (const double megapixels : {0.03, 0.06, 0.12, 0.25, 0.5, 1.0}) {
        testing::LineAccuracy mean;
        std::vector<double> times;
        const auto n = static_cast<double>(testing::letters().size());
        for (const std::string& letter : testing::letters()) {
            const std::vector<testing::Polyline> truth =
                testing::glyph(letter, {}, {1000.0, 750.0}, 1100.0);
            testing::Canvas canvas(full, {215, 225, 230});
            canvas.fill(truth, {60, 50, 40});
            const cv::Mat photo =
                testing::seen(canvas.picture(), {.blur_px = 2.0, .noise_levels = 6.0});
            cv::Mat small;
            PhotoLines found;
            times.push_back(ms_of([&] {
                small = reduced(photo, 1e6 * megapixels);
                found = photo_lines(small, shown_width_mm);
            }));
            const double scale = static_cast<double>(full.width) / small.cols;
            for (Chain& chain : found.chains) {
                for (EdgePoint& p : chain.points) {
                    p.at = scale * (p.at + cv::Point2d(0.5, 0.5));
                }
            }
            const testing::LineAccuracy accuracy = accuracy_of(found.chains, truth);
            mean.rms_px += accuracy.rms_px / n;
            mean.greatest_px += accuracy.greatest_px / n;
        }
        const double mm = shown_width_mm / full.width;
        fmt::print(csv, "{},{:.3f},{:.3f},{:.1f}\n", megapixels, mean.rms_px * mm,
                   mean.greatest_px * mm, median(times));
    }
}

bool write_stages(const std::string& results) {
    std::ofstream stages(results + "/stages.csv");
    fmt::print(stages, "stage,least_ms,median_ms\n");
    for (const StageTime& time : still_stages(stage_runs)) {
        fmt::print(stages, "{},{:.1f},{:.1f}\n", time.stage, time.least_ms, time.median_ms);
    }
    return stages.good();
}

int run(const std::string& results, const std::string& photos) {
    std::vector<std::pair<std::string, std::vector<MarkedPicture>>> sets;
    sets.emplace_back("pictograms", made_pictures());
    if (!photos.empty()) {
        Result<std::vector<MarkedPicture>> read = pictures_in(photos);
        if (!read) {
            fmt::print(stderr, "{}\n", read.error().line);
            return EXIT_FAILURE;
        }
        sets.emplace_back("photos", std::move(*read));
    }
    std::ofstream scores(results + "/detectors.csv");
    std::ofstream repeats(results + "/repeats.csv");
    fmt::print(scores, "set,detector,setting,f,precision,recall,best_f,ms\n");
    fmt::print(repeats, "set,change,f\n");
    for (const auto& [name, pictures] : sets) {
        score(name, pictures, scores);
        score_repeats(name, pictures, repeats);
    }
    std::ofstream sizes(results + "/sizes.csv");
    fmt::print(sizes, "megapixels,rms_mm,hausdorff_mm,ms\n");
    score_sizes(sizes);
    return scores && repeats && sizes && write_stages(results) ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc < 2 || argc > 3) {
        fmt::print(stderr, "usage: vision_bench RESULTS [--stages | FOLDER OF MARKED PHOTOS]\n");
        return 2;
    }
    cv::setNumThreads(1);
    const std::string what = argc > 2 ? argv[2] : "";
    if (what == "--stages") {
        return touchline::bench::write_stages(argv[1]) ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    return touchline::bench::run(argv[1], what);
}
