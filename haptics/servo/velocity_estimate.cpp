#include "haptics/servo/velocity_estimate.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

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

}  // namespace touchline
