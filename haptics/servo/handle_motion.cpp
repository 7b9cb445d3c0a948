#include "haptics/servo/handle_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr double key_rad_per_s = 2.0;
constexpr double most_ahead_rad = 0.35;
// How far the positions' velocity may be off: a hand that changes it by 10 m/s^2 is seen 5 ms late.
constexpr double unsure_m_per_s = 0.05;
constexpr double unsure_share = 0.25;
constexpr double most_late_s = 0.0045;  // no device tells an older place

/// One axis: the slopes that keep every sample looked at so far within the noise, and the slope of
/// the longest line that did.
class Axis {
  public:
    /// `rise_m`: from a sample to the newest, which came `span_s` later.
    void look_at(double rise_m, double span_s, double noise_m) {
        if (is_over_) return;
        const double slope = rise_m / span_s;
        is_over_ = !(slope >= low_ && slope <= high_);
        if (is_over_) return;
        slope_ = slope;
        const double spread = noise_m / span_s;
        low_ = std::max(low_, slope - spread);
        high_ = std::min(high_, slope + spread);
    }

    [[nodiscard]] bool is_over() const { return is_over_; }

    [[nodiscard]] double slope() const { return slope_; }

  private:
    double low_ = -INFINITY;
    double high_ = INFINITY;
    double slope_ = 0.0;
    bool is_over_ = false;
};

double count_of(const std::optional<TurningHandle>& handle) {
    return handle ? encoder_quantum_rad(*handle) : 1e-3;
}

}  // namespace

Velocity VelocityEstimate::step(Position position, double dt_s) {
    velocity_ = {};
    if (!is_finite(position) || !(dt_s > 0.0)) {
        reset();
        return velocity_;
    }
    newest_ = (newest_ + 1) % samples_.size();
    samples_[newest_] = {position, dt_s};
    count_ = std::min(count_ + 1, samples_.size());
    Axis x;
    Axis y;
    double span_s = 0.0;
    for (std::size_t i = 1; i < count_ && !(x.is_over() && y.is_over()); ++i) {
        span_s += back(i - 1).dt_s;
        const Position rise = position - back(i).position;
        x.look_at(rise.x, span_s, noise_m_);
        y.look_at(rise.y, span_s, noise_m_);
    }
    velocity_ = {x.slope(), y.slope()};
    return velocity_;
}

void HandleTurn::step(std::optional<double> device_rad, double wanted_rad, double shape_rad,
                      double dt_s) {
    double next_rad = device_rad.value_or(wanted_rad);
    if (!std::isfinite(next_rad)) next_rad = angle_rad_;
    if (!device_rad) {
        const double most_rad = key_rad_per_s * dt_s;
        const double near_rad =
            std::clamp(next_rad, shape_rad - most_ahead_rad, shape_rad + most_ahead_rad);
        next_rad = std::clamp(near_rad, angle_rad_ - most_rad, angle_rad_ + most_rad);
    }
    turned_rad_ = next_rad - angle_rad_;
    angle_rad_ = next_rad;
    (void)speed_.step({angle_rad_, 0.0}, dt_s);
}

HandleMotion::HandleMotion(const DeviceProfile& profile)
    : guard_(encoder_step_m(profile)),
      velocity_(encoder_step_m(profile)),
      turn_(count_of(profile.handle)) {}

/// Where the handle is, or was a few ticks ago: a jump is not believed at once. A place that was
/// late may be older than it seems, and the way to the next one then took longer.
void HandleMotion::judge(const StepInput& input, HandleReading& handle) {
    const bool is_told = input.reading && input.reading->p_D && is_finite(*input.reading->p_D);
    if (!is_told || !input.reading->freshness.is_new) {
        guard_.miss(handle.dt_s);
        handle.is_placed = is_told && p_DH_.has_value();
        if (handle.is_placed) handle.jacobian = jacobian_;
        return;
    }
    const double late_s = input.reading->freshness.late_s;
    const double more_s = std::clamp(late_s_ - late_s, 0.0, most_late_s);  // NaN stays
    late_s_ = late_s;
    unseen_s_ += more_s;
    const Sample sample = guard_.step(*input.reading->p_D, handle.dt_s + more_s);
    if (sample != Sample::held) {
        p_DH_ = input.reading->p_D;
        jacobian_ = input.reading->jacobian;
    }
    handle.is_placed = p_DH_.has_value();
    handle.jacobian = jacobian_;
    handle.has_jumped = sample == Sample::jumped;
}

/// A device's own velocity is finer than that of its positions, but only these cannot lie.
Velocity HandleMotion::believed(const std::optional<DeviceReading>& told) const {
    const Velocity seen = velocity_.velocity();
    if (!told || !told->p_D || !told->velocity_D) return seen;
    const Velocity measured = turned(*told->velocity_D);
    const double most_m_per_s = unsure_m_per_s + unsure_share * norm(seen);
    return norm(measured - seen) <= most_m_per_s ? measured : seen;
}

HandleReading HandleMotion::step(const DeviceProfile& profile, const StepInput& input,
                                 std::optional<double> shape_rad, double period_s, double dt_s) {
    silent_s_ = input.reading ? 0.0 : silent_s_ + period_s;
    HandleReading handle;
    handle.dt_s = dt_s;
    judge(input, handle);
    const bool begins_anew = !handle.is_placed || handle.has_jumped;
    if (begins_anew) velocity_.reset();
    unseen_s_ = begins_anew ? dt_s : unseen_s_ + dt_s;
    if (handle.is_placed) {
        const Position before = p_WH_;
        p_WH_ = picture_from_device(profile, *p_DH_);
        handle.moved = p_WH_ - before;
        if (input.reading->freshness.is_new)
            (void)velocity_.step(p_WH_, std::exchange(unseen_s_, 0.0));
        turn_.step(input.reading->handle_rad, input.commands.turn_rad,
                   shape_rad.value_or(turn_.angle_rad()), dt_s);
    }
    handle.silent_s = silent_s_;
    handle.p_WH = p_WH_;
    handle.velocity = believed(input.reading);
    handle.angle_rad = turn_.angle_rad();
    handle.turned_rad = turn_.turned_rad();
    handle.rad_per_s = turn_.rad_per_s();
    return handle;
}

}  // namespace touchline
