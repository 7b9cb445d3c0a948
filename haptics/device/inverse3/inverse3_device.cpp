#include "haptics/device/inverse3/inverse3_device.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double oldest_place_s = 0.0045;
constexpr double pause_of_end_s = 0.001;
constexpr int longest_end_of_force_ms = 100;
constexpr double height_smoothing_s = 0.003;

// D is the picture's frame turned by half a turn, and the service's x and y are the picture's.
Position seen_from_above(Space place_m) {
    return {-place_m.x, -place_m.y};
}

}  // namespace

Inverse3Device::~Inverse3Device() {
    (void)stop();
}

std::optional<DeviceReading> Inverse3Device::read(double now_s) {
    const double elapsed_s = last_s_ && now_s > *last_s_ ? now_s - *last_s_ : 0.0;
    if (std::isfinite(now_s)) last_s_ = now_s;
    if (!link_) return std::nullopt;
    const ArmNews news = link_->news();
    age_s_ += elapsed_s;
    if (news.places != news_.places) {
        follow_height(news.place_m.z - inverse3_plane_m, age_s_);
        age_s_ = 0.0;
    }
    news_ = news;
    report_ = {judge(news), news.hindrance, report_.was_force_not_finite, news.places,
               news.no_news};
    if (report_.state != ArmState::ready) {
        is_height_known_ = false;
        return std::nullopt;
    }
    DeviceReading reading;
    reading.freshness = {std::exchange(handed_over_, news.places) != news.places, news.way_s};
    reading.p_D = seen_from_above(news.place_m);
    if (const auto& v = news.velocity_m_per_s) reading.velocity_D = Velocity{-v->x, -v->y};
    reading.off_plane = OffPlane{
        off_m_, off_m_per_s_, share_on_plane(profile_.cartesian->spring, off_m_), told_.force_N.z};
    return reading;
}

ArmState Inverse3Device::judge(const ArmNews& news) const {
    if (news.is_gone) return ArmState::lost;
    if (news.hindrance != Hindrance::none) return ArmState::hindered;
    const bool is_in_step = news.answered > 0 && news.places > 0;
    return is_in_step && age_s_ < oldest_place_s ? ArmState::ready : ArmState::waiting;
}

// The service tells a velocity, but not always, and nobody checks that of the third axis.
void Inverse3Device::follow_height(double off_m, double dt_s) {
    const double seen_m_per_s = dt_s > 0.0 ? (off_m - off_m_) / dt_s : 0.0;
    const double share = dt_s / (dt_s + height_smoothing_s);
    off_m_per_s_ = is_height_known_ ? off_m_per_s_ + share * (seen_m_per_s - off_m_per_s_) : 0.0;
    off_m_ = off_m;
    is_height_known_ = true;
}

bool Inverse3Device::write(const DeviceCommand& command) {
    if (!link_) return false;
    const bool is_sound = is_finite(command.force_D) && std::isfinite(command.plane_share);
    report_.was_force_not_finite = report_.was_force_not_finite || !is_sound;
    const bool is_zero = !is_sound || (command.force_D == Force{} && command.plane_share == 0.0);
    const bool is_taken = report_.state == ArmState::ready;
    PlaneForce held;
    if (!is_zero && is_taken)
        held = held_to_plane(profile_, command.force_D, off_m_, off_m_per_s_, command.plane_share);
    tell({-held.in_plane_D.x, -held.in_plane_D.y, held.across_N});
    return is_zero ? holds_zero() : is_taken;
}

void Inverse3Device::tell(Space force_N) {
    const bool was_zero = told_.force_N == Space{};
    told_ = {force_N, told_.number + 1};
    if (force_N == Space{} && !was_zero) first_zero_ = told_.number;
    link_->tell(told_);
}

bool Inverse3Device::holds_zero() {
    const ArmNews news = link_->news();
    return told_.force_N == Space{} && news.answered >= first_zero_ && news.applies_none;
}

bool Inverse3Device::end_in_zero() {
    for (int i = 0; i < longest_end_of_force_ms && link_ && !link_->news().is_gone; ++i) {
        if (write({})) return true;
        link_->rest(pause_of_end_s);
    }
    return false;
}

bool Inverse3Device::stop() {
    if (!link_) return false;
    const bool is_zero = end_in_zero();
    link_.reset();
    report_.state = ArmState::lost;
    return is_zero;
}

}  // namespace touchline
