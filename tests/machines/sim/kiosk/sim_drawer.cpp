#include "tests/machines/sim/kiosk/sim_drawer.h"

#include <algorithm>
#include <array>

namespace touchline {
namespace {

constexpr double reach_x_m = 0.065, reach_y_m = 0.05;  // a little beside the area too
constexpr double longest_pause_s = 3.0;
constexpr double rests_s = 15.0;  // with the pen down

}  // namespace

Position SimDrawer::somewhere() {
    const double x_m = dice_.between(-reach_x_m, reach_x_m);
    const double y_m = dice_.between(-reach_y_m, reach_y_m);
    return {x_m, y_m};
}

void SimDrawer::act(KioskLife& life, double now_s) {
    if (!life.kiosk->takes_pen()) {
        way_.clear();
        return;
    }
    if (now_s < next_s_) {
        moved_s_ = now_s;
        return;
    }
    way_.empty() ? begin(life, now_s) : go_on(life, now_s);
}

void SimDrawer::begin(KioskLife& life, double now_s) {
    moved_s_ = now_s;
    constexpr std::array keys{Key{'U'}, Key{'Y'}, Key::remove};
    const double share = dice_.share();
    if (share < 0.8) return begin_stroke(life);
    next_s_ = now_s + dice_.between(0.2, longest_pause_s);
    if (share < 0.9) return life.press(keys.at(dice_.below(keys.size())));
    at_W_ = somewhere();
    life.kiosk->change_pen({PenMotion::press, at_W_, true});
    life.kiosk->change_pen({PenMotion::lift, at_W_, true});
}

void SimDrawer::begin_stroke(KioskLife& life) {
    at_W_ = somewhere();
    speed_m_per_s_ = dice_.between(0.03, 0.4);
    for (std::uint64_t i = 0, corners = dice_.below(5); i <= corners; ++i)
        way_.push_back(dice_.is_hit(0.05) ? at_W_ : somewhere());
    life.kiosk->change_pen({PenMotion::press, at_W_});
}

void SimDrawer::go_on(KioskLife& life, double now_s) {
    double left_m = speed_m_per_s_ * (now_s - moved_s_);
    moved_s_ = now_s;
    while (!way_.empty()) {
        const Position way = way_.front() - at_W_;
        const double length_m = norm(way);
        if (length_m > left_m) {
            at_W_ += left_m / length_m * way;
            break;
        }
        left_m -= length_m;
        at_W_ = way_.front();
        way_.erase(way_.begin());
    }
    life.kiosk->change_pen({PenMotion::move, at_W_});
    if (!way_.empty()) {
        if (dice_.is_hit(0.002)) next_s_ = now_s + dice_.between(1.0, rests_s);
        return;
    }
    life.kiosk->change_pen({PenMotion::lift, at_W_});
    ++strokes_;
    next_s_ = now_s + dice_.between(0.2, longest_pause_s);
}

}  // namespace touchline
