#include "haptics/resolution/cost_term.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchline {
namespace {

// The time that each opened box adds to a step: 51 ns from 4 to 16 boxes, 38 ns from 16 to 64
// (tests/lab/bench/results/deadline.csv, fractal, median).
constexpr double s_per_box = 50e-9;
constexpr double share_of_period = 0.3;
constexpr double window_ticks = 64.0;
constexpr double shortest_wait_s = 0.5;
constexpr double longest_wait_s = 8.0;
constexpr int lasting_ticks = 4;  // cut in a row: the proxy does not keep up

}  // namespace

Work work_of(const ContactReport& report) {
    return {report.boxes, !(report.clear >= 1.0) || !(report.carried_m <= 0.0)};
}

int affordable_boxes(double period_s) {
    constexpr double most = std::numeric_limits<int>::max();
    return static_cast<int>(std::min(share_of_period * period_s / s_per_box, most));
}

CostTerm::CostTerm(double period_s)
    : period_s_(period_s),
      affordable_(affordable_boxes(period_s)),
      recent_(window_ticks / static_cast<double>(PeakHold::slots)),
      wait_s_(shortest_wait_s) {}

double CostTerm::step(const Work& work, double rendered_level) {
    since_change_s_ += period_s_;
    const double boxes = work.boxes;
    const double worth = work.is_cut ? std::max(boxes, affordable_ + 1.0) : boxes;
    const double most = recent_.step(worth, 1.0);
    cut_in_a_row_ = work.is_cut ? cut_in_a_row_ + 1 : 0;
    if (boxes > affordable_ || cut_in_a_row_ >= lasting_ticks) {
        coarsen(rendered_level);
    } else if (level_ > 0.0 && can_refine(most, rendered_level)) {
        refine();
    }
    return level_;
}

void CostTerm::coarsen(double rendered_level) {
    const double wanted = std::floor(rendered_level) + 1.0;
    if (!(wanted > level_)) return;  // already on the way there
    if (is_refined_) {
        const bool has_lasted = since_change_s_ >= wait_s_;
        wait_s_ = has_lasted ? shortest_wait_s : std::min(2.0 * wait_s_, longest_wait_s);
    }
    level_ = wanted;
    since_change_s_ = 0.0;
    is_refined_ = false;
    cut_in_a_row_ = 0;
}

bool CostTerm::can_refine(double most_boxes, double rendered_level) const {
    if (since_change_s_ < wait_s_) return false;
    const double levels = std::max(rendered_level - (level_ - 1.0), 0.0);
    return most_boxes * std::exp2(levels) <= affordable_;
}

void CostTerm::refine() {
    if (is_refined_) wait_s_ = shortest_wait_s;  // the one before has lasted
    level_ -= 1.0;
    since_change_s_ = 0.0;
    is_refined_ = true;
}

}  // namespace touchline
