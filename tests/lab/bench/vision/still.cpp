#include "tests/lab/bench/vision/still.h"

#include "tests/vision/camera/frames.h"
#include "vision/camera/frame.h"
#include "vision/contour/main_shape.h"
#include "vision/contour/photo_lines.h"
#include "vision/prepare/picture_class.h"
#include "vision/simplify/trace.h"

#include <algorithm>
#include <ctime>
#include <optional>

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

namespace touchline::bench {
namespace {

constexpr std::int64_t kWorking_pixels = 1'000'000;

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
    return to_bgr(still, quick_size(still.size, kWorking_pixels)).value();
}

}  // namespace

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

}  // namespace touchline::bench
