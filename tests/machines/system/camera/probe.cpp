// camera_probe: runs our camera code on whatever libcamera finds, which should be the camera of
// tests/machines/sim/usbredir. Waits for it, compares preview and still with what it shows, waits
// until it is unplugged and plugged in again, and takes another still. Exits with 0 if all of that
// succeeded.
#include "config/types/steady_clock.h"
#include "tests/vision/camera/frames.h"
#include "vision/camera/libcamera_port.h"
#include "vision/camera/stream_camera.h"

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>

namespace {

using namespace touchline;

const cv::Size preview_size(640, 480);
const cv::Size still_size(2048, 1536);
constexpr double most_difference = 4.0;  // grey levels, mean
constexpr double patience_s = 150.0;     // the guest is interpreted

double now_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

int complain(const std::string& line) {
    std::printf("%s\n", line.c_str());
    return 1;
}

/// Steps until `is_there` returns true; false if that takes too long.
bool wait_until(Camera& camera, const std::function<bool(const CameraView&)>& is_there) {
    for (const double start_s = now_s(); now_s() < start_s + patience_s;) {
        if (is_there(camera.step(now_s()))) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

bool is_scene(const cv::Mat& picture, const char* what) {
    const double off = testing::mean_difference(picture, testing::scene(picture.size()));
    std::printf("%s of %d x %d, %.1f grey levels from what the camera shows\n", what, picture.cols,
                picture.rows, off);
    return off < most_difference;
}

bool has_preview(Camera& camera) {
    cv::Mat preview;
    return wait_until(camera,
                      [&](const CameraView& view) {
                          if (view.preview) preview = *view.preview;
                          return view.preview.has_value();
                      }) &&
           preview.size() == preview_size && is_scene(preview, "preview");
}

bool takes_still(Camera& camera) {
    std::optional<Still> still;
    camera.want_still();
    const double start_s = now_s();
    (void)wait_until(camera, [&](const CameraView& view) {
        still = view.still;
        return view.still || view.has_given_up;
    });
    if (!still || still->frame.size != still_size || still->frame.format != PixelFormat::mjpeg)
        return false;
    std::printf("still after %.1f s, sharpness %.0f\n", now_s() - start_s,
                still->quality.sharpness);
    const auto pixels = to_bgr(still->frame, still_size);
    return pixels && is_scene(*pixels, "still") && !still->is_blurred && !still->is_clipped;
}

bool is_gone(const CameraView& view) {
    return view.condition == CameraCondition::absent || view.condition == CameraCondition::stopped;
}

}  // namespace

int main() {
    auto port = LibcameraPort::create();
    if (!port) return complain(port.error().line);
    CaptureLimits limits;
    limits.start_s = 60.0;
    limits.stall_s = 10.0;
    limits.sharpen_s = limits.settle_s = 30.0;
    StreamCamera camera(std::move(*port), limits);
    if (!has_preview(camera)) return complain("no preview came, or another picture");
    for (const CameraName& name : camera.list())
        std::printf("camera: %s (%s)\n", name.name.c_str(), name.id.c_str());
    std::printf("%zu modes, exposure can %sbe held, %s\n", camera.abilities()->modes.size(),
                camera.abilities()->has_exposure_lock ? "" : "not ",
                camera.abilities()->has_two_streams ? "two streams" : "one stream");
    if (!takes_still(camera)) return complain("no still came, or another picture");
    if (!wait_until(camera, is_gone)) return complain("the pulled plug was not noticed");
    std::printf("unplugged, and noticed\n");
    if (!has_preview(camera)) return complain("no preview came after it was plugged in again");
    if (!takes_still(camera)) return complain("no still came after it was plugged in again");
    return 0;
}
