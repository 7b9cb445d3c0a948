#include "app/screen/hand_trail.h"

#include <algorithm>
#include <cstddef>

namespace touchline {
namespace {

constexpr std::int64_t trail_ns = 6'000'000'000;
constexpr double least_step_m = 0.0005;
constexpr std::size_t most_places = 600;
constexpr std::int64_t fading_step_ns = 250'000'000;  // between them a resting hand changes nothing

}  // namespace

void HandTrail::add(Position p_WH, std::int64_t now_ns) {
    while (!places_.empty() && now_ns - places_.front().at_ns > trail_ns) places_.pop_front();
    const bool is_new =
        is_finite(p_WH) && (places_.empty() || norm(p_WH - places_.back().p_WH) >= least_step_m);
    if (is_new) places_.push_back({p_WH, now_ns});
    if (places_.size() > most_places) places_.pop_front();
}

void HandTrail::add_to(Strokes& strokes, const View& view, std::int64_t now_ns, double width_px,
                       Colour colour) const {
    constexpr double first_alpha = 0.7;
    const std::int64_t faded_ns = now_ns - now_ns % fading_step_ns;
    for (std::size_t i = 1; i < places_.size(); ++i) {
        const double age = std::max(
            0.0, static_cast<double>(faded_ns - places_[i].at_ns) / static_cast<double>(trail_ns));
        if (!(age < 1.0)) continue;
        strokes.add_line(view.to_px(places_[i - 1].p_WH), view.to_px(places_[i].p_WH), width_px,
                         {colour, first_alpha * (1.0 - age)});
    }
}

}  // namespace touchline
