#include "vision/camera/stream_camera.h"

#include "vision/camera/frame.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

namespace touchline {
namespace {

const cv::Size least_preview(640, 480);

std::int64_t pixels(const StreamMode& mode) {
    return std::int64_t{mode.size.width} * mode.size.height;
}

/// In the order of PixelFormat: how much it costs to get pixels.
constexpr std::array costs{2, 3, 1, 0};

int cost(const StreamMode& mode) {
    return costs[static_cast<std::size_t>(mode.format)];
}

bool is_enough(const StreamMode& mode) {
    return mode.size.width >= least_preview.width && mode.size.height >= least_preview.height;
}

bool is_better_preview(const StreamMode& a, const StreamMode& b) {
    if (is_enough(a) != is_enough(b)) return is_enough(a);
    const std::int64_t sign = is_enough(a) ? 1 : -1;
    return std::tuple(sign * pixels(a), cost(a)) < std::tuple(sign * pixels(b), cost(b));
}

bool is_better_still(const StreamMode& a, const StreamMode& b) {
    return std::tuple(-pixels(a), cost(a)) < std::tuple(-pixels(b), cost(b));
}

template <class Better>
std::optional<StreamMode> best(const std::vector<StreamMode>& modes, Better is_better) {
    const auto found = std::min_element(modes.begin(), modes.end(), is_better);
    return found == modes.end() ? std::nullopt : std::optional(*found);
}

/// Stills are judged at the size at which outlines are found: a blur that this size hides does no
/// harm.
constexpr std::int64_t judged_pixels = std::int64_t{1024} * 768;

}  // namespace

std::optional<StreamMode> preview_mode(const CameraAbilities& abilities) {
    return best(abilities.modes, is_better_preview);
}

std::optional<StreamMode> still_mode(const CameraAbilities& abilities) {
    return best(abilities.modes, is_better_still);
}

StreamCamera::StreamCamera(std::unique_ptr<CameraPort> port, const CaptureLimits& limits)
    : port_(std::move(port)), limits_(limits), sequence_(limits) {}

StreamCamera::~StreamCamera() {
    port_->close();
}

void StreamCamera::choose(const std::string& id) {
    if (id == wanted_id_) return;
    wanted_id_ = id;
    if (id.empty() || id == id_) return;
    port_->close();
    id_.clear();
    abilities_.reset();
    has_given_up_ = has_given_up_ || sequence_.is_still_pending();
    sequence_ = CaptureSequence(limits_);
}

/// Looks for the camera in use; if there is none, for the wanted one, or any.
bool StreamCamera::is_present() {
    const std::vector<CameraName> cameras = port_->list();
    const auto has = [&](const std::string& id) {
        return std::any_of(cameras.begin(), cameras.end(),
                           [&](const CameraName& camera) { return camera.id == id; });
    };
    if (!id_.empty()) return has(id_);
    if (cameras.empty() || !(wanted_id_.empty() || has(wanted_id_))) return false;
    id_ = wanted_id_.empty() ? cameras.front().id : wanted_id_;
    return true;
}

CameraView StreamCamera::step(double now_s) {
    CameraView view;
    view.has_given_up = std::exchange(has_given_up_, false);
    CaptureInputs in;
    in.is_present = is_present();
    if (std::exchange(has_just_opened_, false)) in.opened = abilities_;
    in.has_refused = std::exchange(has_refused_, false);
    in.is_still_wanted = std::exchange(is_still_wanted_, false);
    if (abilities_ && in.is_present) read_frame(in, view);
    for (const CaptureAction action : sequence_.step(now_s, in)) carry_out(action, view);
    view.condition = sequence_.condition();
    if (!in.is_present) id_.clear();  // any camera may be the next
    return view;
}

/// An unreadable frame counts as none: if all are unreadable, the stream is as good as dead.
void StreamCamera::read_frame(CaptureInputs& in, CameraView& view) {
    std::optional<TakenFrame> taken = port_->take();
    if (!taken) return;
    const bool is_still = taken->is_still || sequence_.is_still_running();
    const cv::Size size = taken->frame.size;
    const auto pixels = to_bgr(taken->frame, is_still ? quick_size(size, judged_pixels)
                                                      : reduced_size(size, preview_pixels));
    if (!pixels) return;
    in.has_frame = true;
    in.is_frame_still = taken->is_still;
    in.loops = taken->loops;
    in.quality = quality_ = measure_quality(*pixels);
    frame_ = std::move(taken->frame);
    if (!is_still) view.preview = *pixels;
}

void StreamCamera::carry_out(CaptureAction action, CameraView& view) {
    switch (action) {
        case CaptureAction::open: {
            auto opened = port_->open(id_);
            has_just_opened_ = opened && preview_mode(*opened);
            has_refused_ = !has_just_opened_;
            if (has_just_opened_) abilities_ = std::move(*opened);
            break;
        }
        case CaptureAction::start_preview:
            start(false);
            break;
        case CaptureAction::start_still:
            start(true);
            break;
        case CaptureAction::request_still:
            port_->request_still();
            break;
        case CaptureAction::focus:
            port_->order(LoopOrder::focus_once);
            break;
        case CaptureAction::lock_exposure:
            port_->order(LoopOrder::lock_exposure);
            break;
        case CaptureAction::free_loops:
            if (abilities_->has_exposure_lock) port_->order(LoopOrder::free_exposure);
            if (abilities_->has_focus_lock) port_->order(LoopOrder::focus_freely);
            break;
        case CaptureAction::keep:
            best_.frame = std::move(frame_);
            best_.quality = quality_;
            break;
        case CaptureAction::deliver:
            best_.is_blurred = sequence_.is_blurred();
            best_.is_clipped = sequence_.is_clipped();
            view.still = std::exchange(best_, {});
            break;
        case CaptureAction::give_up:
            view.has_given_up = true;
            break;
        case CaptureAction::close:
            port_->close();
            abilities_.reset();
            break;
    }
}

void StreamCamera::start(bool is_still) {
    const StreamMode preview = *preview_mode(*abilities_);
    const StreamMode still = *still_mode(*abilities_);
    StreamPlan plan{is_still ? still : preview, std::nullopt};
    if (abilities_->has_two_streams) plan.still = still;
    has_refused_ = !port_->start(plan).has_value() || has_refused_;
}

}  // namespace touchline
