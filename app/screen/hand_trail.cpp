#include "app/screen/hand_trail.h"

#include <algorithm>
#include <cstddef>

namespace touchline {
namespace {

constexpr std::int64_t trail_ns = 6'000'000'000;
constexpr double least_step_m = 0.0005;
constexpr double longest_step_m = 0.015;  // between frames: farther is not the hand's own way
constexpr std::size_t most_places = 600;
constexpr std::int64_t fading_step_ns = 1'500'000'000;  // of a hand that rests

}  // namespace

void HandTrail::add(Position p_WH, std::int64_t now_ns) {
    const bool is_new =
        is_finite(p_WH) && (places_.empty() || norm(p_WH - places_.back().p_WH) >= least_step_m);
    if (is_new) places_.push_back({p_WH, now_ns});
    if (is_new || now_ns - faded_ns_ >= fading_step_ns) faded_ns_ = now_ns;
    while (!places_.empty() && faded_ns_ - places_.front().at_ns > trail_ns) places_.pop_front();
    if (places_.size() > most_places) places_.pop_front();
}

void HandTrail::add_to(Strokes& strokes, const View& view, double width_px, Colour colour) const {
    constexpr double first_alpha = 0.7;
    for (std::size_t i = 1; i < places_.size(); ++i) {
        if (norm(places_[i].p_WH - places_[i - 1].p_WH) > longest_step_m) continue;
        const double age =
            static_cast<double>(faded_ns_ - places_[i].at_ns) / static_cast<double>(trail_ns);
        strokes.add_line(view.to_px(places_[i - 1].p_WH), view.to_px(places_[i].p_WH), width_px,
                         {colour, first_alpha * (1.0 - age)});
    }
}

}  // namespace touchline
