// Where pictures come from at a simulated site. Threads: one.
#pragma once

#include "app/kiosk/stick_source.h"
#include "vision/camera/camera.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace touchline {

/// Sticks that come, are listed and are pulled out, on a virtual clock.
class SimFileSource final : public FileSource {
  public:
    /// Puts in a stick with these files; listing takes so long.
    void put(std::vector<FilePtr> files, double listing_s) {
        files_ = std::move(files);
        listing_s_ = listing_s;
        root_ = "stick";
        is_new_ = true;
    }

    [[nodiscard]] bool is_in() const { return !root_.empty(); }

    /// Pulls the stick out at any moment, even while it is listed.
    void pull() {
        if (root_.empty()) return;
        root_.clear();
        due_ns_.reset();
        is_new_ = false;
        is_gone_ = true;
    }

    [[nodiscard]] std::optional<FilesChange> poll(std::int64_t now_ns) override {
        if (std::exchange(is_gone_, false)) return FilesChange{};
        if (std::exchange(is_new_, false))
            due_ns_ = now_ns + static_cast<std::int64_t>(1e9 * listing_s_);
        if (!due_ns_ || now_ns < *due_ns_) return std::nullopt;
        due_ns_.reset();
        return FilesChange{files_, {}};
    }

    [[nodiscard]] bool is_listing() const override { return due_ns_.has_value(); }

    void allow(FileSystems /*allowed*/) override {}

    void end_session() override { pull(); }

    /// Returns no root: another program would read it in its own time.
    [[nodiscard]] const std::string& root() const override { return no_root_; }

    [[nodiscard]] bool is_watching() const override { return true; }

  private:
    std::vector<FilePtr> files_;
    double listing_s_ = 0.0;
    std::string root_;
    std::string no_root_;
    bool is_new_ = false;
    bool is_gone_ = false;
    std::optional<std::int64_t> due_ns_;
};

/// A camera above a sheet with a drawing; it can be unplugged.
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
