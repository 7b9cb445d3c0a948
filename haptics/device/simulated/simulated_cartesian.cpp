#include "haptics/device/simulated/simulated_cartesian.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double longest_pause_s = 0.1;

TipParameters mass_of(const MechanicsProfile& mechanics) {
    return {mechanics.tip_mass_kg, mechanics.viscous_Ns_per_m, mechanics.coulomb_N};
}

Position on_plane(const IntendedPath* across) {
    return across == nullptr ? Position{} : Position{across->at(0.0).position.x, 0.0};
}

double in_steps(double metres, double step_m) {
    return std::round(metres / step_m) * step_m;
}

}  // namespace

SimulatedCartesian::SimulatedCartesian(const DeviceProfile& profile,
                                       const CartesianOptions& options,
                                       std::shared_ptr<const IntendedPath> path,
                                       std::shared_ptr<const IntendedPath> across)
    : profile_(profile),
      options_(options),
      path_(std::move(path)),
      across_path_(std::move(across)),
      plane_(mass_of(profile.mechanics), options.hand, path_->at(0.0).position),
      across_(mass_of(profile.mechanics), options.hand, on_plane(across_path_.get())) {}

std::optional<DeviceReading> SimulatedCartesian::read(double now_s) {
    if (now_s > time_s_) {
        time_s_ = std::max(time_s_, now_s - longest_pause_s);
        advance_to(now_s);
    }
    const double step_m = encoder_step_m(profile_);
    const Position p_D = device_from_picture(profile_, tip().position);
    DeviceReading told;
    told.p_D = Position{in_steps(p_D.x, step_m), in_steps(p_D.y, step_m)};
    told.velocity_D = turned(tip().velocity);
    told.off_plane =
        OffPlane{off_m(), across_.tip().velocity.x,
                 share_on_plane(profile_.cartesian->spring, off_m()), acting_.across_N};
    return told;
}

bool SimulatedCartesian::write(const DeviceCommand& command) {
    pending_.push(time_s_ + profile_.mechanics.delay_s, command);
    return true;
}

void SimulatedCartesian::advance_to(double t_s) {
    while (const auto* const next = pending_.due(t_s)) {
        advance(next->from_s - time_s_);
        told_ = next->command;
        pending_.pop();
    }
    advance(t_s - time_s_);
    time_s_ = t_s;
    // Also where no time passed for the mechanics.
    acting_ = held_to_plane(profile_, told_.force_D, off_m(), across_.tip().velocity.x,
                            told_.plane_share);
}

void SimulatedCartesian::advance(double span_s) {
    if (!(span_s > 0.0)) return;
    const double steps = std::max(1.0, std::ceil(span_s / options_.substep_s - 1e-6));
    const double h_s = span_s / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        acting_ = held_to_plane(profile_, told_.force_D, off_m(), across_.tip().velocity.x,
                                told_.plane_share);
        plane_.step(turned(acting_.in_plane_D), path_->at(time_s_), h_s);
        Intention across = across_path_ ? across_path_->at(time_s_) : Intention{};
        across.position.y = across.velocity.y = 0.0;
        across_.step({acting_.across_N, 0.0}, across, h_s);
        time_s_ += h_s;
    }
}

}  // namespace touchline
