#include "haptics/device/pantograph_plant.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

Position start_of(const DeviceProfile& profile, const IntendedPath& path) {
    const Position wanted = path.at(0.0).position;
    return inverse(profile.geometry, device_from_picture(profile, wanted)) ? wanted : Position{};
}

TipParameters tip_of(const MechanicsProfile& mechanics) {
    return {mechanics.tip_mass_kg, mechanics.viscous_Ns_per_m, mechanics.coulomb_N};
}

}  // namespace

PantographPlant::PantographPlant(const DeviceProfile& profile, const HandModel& hand,
                                 double longest_step_s, std::shared_ptr<const IntendedPath> path)
    : profile_(profile),
      longest_step_s_(longest_step_s),
      path_(std::move(path)),
      dynamics_(tip_of(profile.mechanics), hand, start_of(profile, *path_)) {
    if (profile.handle) handle_.emplace(*profile.handle, hand, path_->at(0.0).angle_rad);
}

void PantographPlant::advance(double span_s) {
    if (!(span_s > 0.0)) return;
    const double steps = std::max(1.0, std::ceil(span_s / longest_step_s_ - 1e-6));
    const double h_s = span_s / steps;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
        const Position before = dynamics_.tip().position;
        const Intention intention = path_->at(time_s_);
        dynamics_.step(force_W(), intention, h_s);
        if (handle_) handle_->step(handle_Nm_, intention, h_s);
        time_s_ += h_s;
        // The links stop the tip at their full reach.
        if (!angles()) dynamics_.stop_at(before);
    }
}

std::optional<JointAngles> PantographPlant::angles() const {
    return inverse(profile_.geometry, device_from_picture(profile_, dynamics_.tip().position));
}

Force PantographPlant::force_W() const {
    const auto at = angles();
    const auto pose = at ? forward(profile_.geometry, *at) : std::nullopt;
    const auto force_D = pose ? tip_force(pose->jacobian, torques_) : std::nullopt;
    return force_D ? turned(*force_D) : Force{};
}

}  // namespace touchline
