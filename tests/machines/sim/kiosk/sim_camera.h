// A camera above a sheet with a drawing; it can be unplugged. Threads: one.
#pragma once

#include "vision/camera/camera.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {

class SimCamera final : public Camera {
  public:
    [[nodiscard]] std::vector<CameraName> list() override { return {}; }

    void choose(const std::string& /*id*/) override {}

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override { return std::nullopt; }

    void want_still() override { is_wanted_ = true; }

    [[nodiscard]] CameraView step(double now_s) override {
        CameraView view;
        view.condition = condition;
        if (!is_wanted_) return view;
        if (!due_s_) due_s_ = now_s + still_s;
        if (condition != CameraCondition::ready) {
            view.has_given_up = true;
        } else if (now_s >= *due_s_) {
            view.still = Still{drawing(), {}, false, false};
        } else {
            return view;
        }
        is_wanted_ = false;
        due_s_.reset();
        return view;
    }

    CameraCondition condition = CameraCondition::ready;

  private:
    static constexpr double still_s = 0.7;

    static CameraFrame drawing() {
        cv::Mat sheet(240, 320, CV_8UC3, cv::Scalar::all(235));
        const std::vector<cv::Point> triangle{{60, 200}, {160, 40}, {260, 200}};
        cv::polylines(sheet, triangle, true, cv::Scalar::all(20), 5);
        CameraFrame frame;
        frame.size = sheet.size();
        frame.stride_bytes = sheet.step;
        frame.bytes.assign(sheet.data, sheet.data + sheet.total() * sheet.elemSize());
        return frame;
    }

    bool is_wanted_ = false;
    std::optional<double> due_s_;
};

}  // namespace touchline
