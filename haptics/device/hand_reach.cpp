#include "haptics/device/hand_reach.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double tip_speed_m_per_s = 1.5;   // faster than any hand at the handle
constexpr double joint_speed_per_s = 60.0;  // where a turn moves the tip little

}  // namespace

bool can_a_hand_move(const DeviceProfile& profile, JointAngles from, JointAngles to, double age_s) {
    if (!is_finite(from) || !is_finite(to)) return false;
    const double span_s = age_s + sampling_s;
    const JointAngles quantum = encoder_quantum(profile);
    const double turned = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    if (!(turned <= joint_speed_per_s * span_s + 2.0 * std::max(quantum.x, quantum.y)))
        return false;
    const auto before = forward(profile.geometry, from);
    const auto after = forward(profile.geometry, to);
    if (!before || !after) return true;
    const double count_m = singular_values(before->jacobian, quantum).largest;
    return norm(after->p_DH - before->p_DH) <= tip_speed_m_per_s * span_s + 2.0 * count_m;
}

}  // namespace touchline
