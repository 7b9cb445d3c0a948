#include "vision/camera/stream_choice.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace touchline {
namespace {

const cv::Size least_preview(640, 480);

std::int64_t pixels(const StreamMode& mode) {
    return std::int64_t{mode.size.width} * mode.size.height;
}

int cost(PixelFormat format) {
    switch (format) {
        case PixelFormat::bgr:
            return 0;
        case PixelFormat::nv12:
            return 1;
        case PixelFormat::yuyv:
            return 2;
        case PixelFormat::mjpeg:
            return 3;
    }
    return 4;
}

bool is_enough(const StreamMode& mode) {
    return mode.size.width >= least_preview.width && mode.size.height >= least_preview.height;
}

bool is_better_preview(const StreamMode& a, const StreamMode& b) {
    if (is_enough(a) != is_enough(b)) return is_enough(a);
    const std::int64_t sign = is_enough(a) ? 1 : -1;
    return std::tuple(sign * pixels(a), cost(a.format)) <
           std::tuple(sign * pixels(b), cost(b.format));
}

bool is_better_still(const StreamMode& a, const StreamMode& b) {
    return std::tuple(-pixels(a), cost(a.format)) < std::tuple(-pixels(b), cost(b.format));
}

template <class Better>
std::optional<StreamMode> best(const std::vector<StreamMode>& modes, Better is_better) {
    const auto found = std::min_element(modes.begin(), modes.end(), is_better);
    return found == modes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<StreamMode> preview_mode(const CameraAbilities& abilities) {
    return best(abilities.modes, is_better_preview);
}

std::optional<StreamMode> still_mode(const CameraAbilities& abilities) {
    return best(abilities.modes, is_better_still);
}

}  // namespace touchline
