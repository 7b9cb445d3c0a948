#include "tests/vision/camera/fake_port.h"

#include "tests/vision/camera/frames.h"

#include <algorithm>
#include <map>

#include <opencv2/imgproc.hpp>

namespace touchline::testing {
namespace {

constexpr double frame_s = 0.1;

std::string words(cv::Size size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

struct LookNow {
    bool is_blurred = false;
    bool is_dark = false;
    bool is_clipped = false;
    auto operator<=>(const LookNow&) const = default;
};

/// Draws each frame once for all tests.
const CameraFrame& drawn(cv::Size size, const LookNow& look) {
    static std::map<std::pair<std::pair<int, int>, LookNow>, CameraFrame> known;
    CameraFrame& frame = known[{{size.width, size.height}, look}];
    if (!frame.bytes.empty()) return frame;
    cv::Mat picture = scene(size);
    if (look.is_blurred) cv::GaussianBlur(picture, picture, {}, size.width / 100.0);
    if (look.is_dark) picture *= 0.4;
    if (look.is_clipped) picture.colRange(0, size.width / 4).setTo(cv::Scalar::all(255));
    frame = {PixelFormat::bgr, size, 3 * static_cast<std::size_t>(size.width), {}};
    frame.bytes.assign(picture.data, picture.data + 3 * picture.total());
    return frame;
}

}  // namespace

FakeCamera usb_camera(const std::string& id) {
    FakeCamera camera;
    camera.id = id;
    camera.abilities.modes = {{PixelFormat::yuyv, {320, 240}},
                              {PixelFormat::yuyv, {640, 480}},
                              {PixelFormat::mjpeg, {640, 480}},
                              {PixelFormat::mjpeg, {1280, 960}}};
    camera.abilities.has_exposure_lock = true;
    return camera;
}

FakeCamera board_camera(const std::string& id) {
    FakeCamera camera;
    camera.id = id;
    camera.abilities = {
        {{PixelFormat::nv12, {640, 480}}, {PixelFormat::nv12, {1280, 960}}}, true, true, true};
    camera.tells_loops = true;
    return camera;
}

FakeCamera* FakePort::find(const std::string& id) {
    const auto found = std::find_if(cameras.begin(), cameras.end(), [&](const FakeCamera& camera) {
        return camera.id == id && camera.is_plugged;
    });
    return found == cameras.end() ? nullptr : &*found;
}

std::vector<CameraName> FakePort::list() {
    std::vector<CameraName> names;
    for (const FakeCamera& camera : cameras)
        if (camera.is_plugged) names.push_back({camera.id, "camera " + camera.id});
    return names;
}

Result<CameraAbilities> FakePort::open(const std::string& id) {
    expect(open_ == nullptr);
    log.push_back("open " + id);
    FakeCamera* camera = find(id);
    if (camera == nullptr || camera->refuses_open) return failure("no");
    open_ = camera;
    return camera->abilities;
}

Result<void> FakePort::start(const StreamPlan& plan) {
    expect(open_ != nullptr);
    if (open_ == nullptr) return failure("no camera is open");
    const auto& modes = open_->abilities.modes;
    expect(std::find(modes.begin(), modes.end(), plan.preview) != modes.end());
    expect(plan.still.has_value() == open_->abilities.has_two_streams);
    log.push_back("start " + words(plan.preview.size));
    if (open_->refuses_start) return failure("no");
    plan_ = plan;
    started_s_ = last_frame_s_ = now_s;
    stills_left_ = 0;
    return {};
}

void FakePort::order(LoopOrder order) {
    expect(open_ != nullptr);
    if (open_ == nullptr) return;
    const bool is_focus = order == LoopOrder::focus_once || order == LoopOrder::focus_freely;
    expect(is_focus ? open_->abilities.has_focus_lock : open_->abilities.has_exposure_lock);
    if (order == LoopOrder::focus_once) focus_ordered_s_ = now_s;
    if (order == LoopOrder::lock_exposure) {
        is_attempt_clipped_ = open_->clipped_stills > 0;
        open_->clipped_stills -= is_attempt_clipped_ ? 1 : 0;
    }
    switch (order) {
        case LoopOrder::lock_exposure:
            log.emplace_back("lock");
            break;
        case LoopOrder::free_exposure:
            log.emplace_back("free");
            break;
        case LoopOrder::focus_once:
            log.emplace_back("focus");
            break;
        case LoopOrder::focus_freely:
            log.emplace_back("unfocus");
            break;
    }
}

void FakePort::request_still() {
    expect(open_ != nullptr && open_->abilities.has_two_streams && plan_);
    ++stills_left_;
}

CameraFrame FakePort::frame_now(cv::Size size) const {
    const double age_s = now_s - started_s_;
    return drawn(size, {open_->is_never_sharp || age_s < open_->sharpens_s,
                        age_s < open_->brightens_s, is_attempt_clipped_});
}

std::optional<TakenFrame> FakePort::take() {
    if (open_ == nullptr || !plan_ || !open_->is_plugged || open_->is_dead) return std::nullopt;
    if (now_s - last_frame_s_ < frame_s - 1e-9) return std::nullopt;
    last_frame_s_ = now_s;
    TakenFrame taken;
    taken.is_still = stills_left_ > 0 && !open_->is_still_dead;
    taken.frame = frame_now(taken.is_still ? plan_->still->size : plan_->preview.size);
    if (taken.is_still) --stills_left_;
    if (open_->is_garbled) taken.frame.bytes.resize(taken.frame.bytes.size() / 2);
    if (open_->tells_loops) {
        taken.loops.is_focused = now_s - focus_ordered_s_ >= open_->focuses_s;
        taken.loops.is_exposure_settled = now_s - started_s_ >= open_->brightens_s;
    }
    return taken;
}

void FakePort::close() {
    if (open_ != nullptr) log.emplace_back("close");
    open_ = nullptr;
    plan_.reset();
}

}  // namespace touchline::testing
