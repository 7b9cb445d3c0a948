#include "tests/machines/sim/kiosk/sim_visitor.h"

#include "tests/machines/sim/kiosk/house.h"

#include <algorithm>
#include <array>
#include <vector>

namespace touchline {
namespace {

constexpr std::array grips{light_hand, normal_hand, relaxed_arm, stiff_arm};
constexpr double half_width_m = 0.045, half_height_m = 0.033;  // of the area where hands wander
constexpr double tap_m = 0.012;
constexpr double pushed_m = 0.025;    // beyond a line
constexpr double farewell_s = 150.0;  // then nobody waits any longer for a visitor who walked away

bool is_leading(const Kiosk& kiosk) {
    return kiosk.hand().guidance.phase == GuidancePhase::running;
}

int id_of_focus(const SpokenScreen& screen) {
    return screen.focus ? screen.items[*screen.focus].id : -1;
}

}  // namespace

SimVisitor::SimVisitor(const PlannedVisit& visit) : visit_(visit), dice_(visit.seed) {
    grip_ = grips.at(dice_.below(grips.size()));
    pace_s_ = dice_.between(0.4, 2.5);
    if (dice_.is_hit(0.3)) tremor_m_ = dice_.between(5e-5, 8e-4);
    walks_away_ = dice_.is_hit(0.25);
    keeps_off_ = dice_.is_hit(0.08);
    constexpr std::array wishes{VisitItem::practise, VisitItem::gallery, VisitItem::gallery,
                                VisitItem::gallery,  VisitItem::stick,   VisitItem::camera};
    wish_ = wishes.at(dice_.below(wishes.size()));
    next_key_s_ = visit.at_s;
    if (visit.draws) wish_ = VisitItem::draw_for_me;
}

std::optional<KeyRole> SimVisitor::act(const VisitorPlace& place) {
    if (is_visit_on(place.kiosk.visit())) {
        has_begun_ = true;
    } else if (has_begun_ || place.now_s > visit_.at_s + visit_.length_s + farewell_s) {
        let_go(place);
        is_gone_ = true;
        return std::nullopt;
    }
    if (is_leaving(place.now_s) && walks_away_) {
        let_go(place);
        return std::nullopt;
    }
    if (wish_ == VisitItem::stick && !has_stick_ && has_begun_) bring_stick(place);
    move(place);
    return key(place);
}

void SimVisitor::bring_stick(const VisitorPlace& place) {
    has_stick_ = true;
    std::vector<FilePtr> files;
    const std::vector<FilePtr>& gallery = gallery_without_workers().files.front();
    for (std::uint64_t i = 0, count = 1 + dice_.below(4); i < count; ++i) {
        PictureFile file = *gallery[dice_.below(gallery.size())];
        file.is_private = true;
        files.push_back(std::make_shared<const PictureFile>(std::move(file)));
    }
    place.sticks.put(std::move(files), dice_.between(0.2, 2.0));
}

void SimVisitor::hold(const VisitorPlace& place, const HandModel& hand) {
    if (!holds_) place.hand.follow(place.board.plant().tip().position);
    holds_ = true;
    place.board.grip(hand);
}

void SimVisitor::let_go(const VisitorPlace& place) {
    if (!holds_) return;
    holds_ = false;
    place.board.grip(no_hand);
}

void SimVisitor::throw_handle(const VisitorPlace& place, double speed_m_per_s) {
    if (!holds_ || place.is_calm) return;
    begin(Doing::jerking, place);
    place.hand.go(somewhere(half_width_m, half_height_m), speed_m_per_s, place.awake_s);
}

Position SimVisitor::somewhere(double most_x_m, double most_y_m) {
    const double x_m = dice_.between(-most_x_m, most_x_m);
    const double y_m = dice_.between(-most_y_m, most_y_m);
    return {x_m, y_m};
}

void SimVisitor::move(const VisitorPlace& place) {
    if (place.hand.is_homing()) {
        holds_ = false;  // one hand at a time
        return;
    }
    const bool is_off = place.now_s < hands_off_until_s_ && !place.is_calm;
    if (is_off || keeps_off_ || !has_begun_) return let_go(place);
    place.hand.tremble(place.is_calm ? 0.0 : tremor_m_, 9.0);
    if (is_leading(place.kiosk)) {
        hold(place, light_hand);
        place.hand.follow(place.board.plant().tip().position);
        return;
    }
    if (place.now_s >= next_doing_s_ || (place.is_calm && doing_ != Doing::tracing)) {
        next_doing_s_ = place.now_s + dice_.between(1.0, 8.0);
        begin(place.is_calm ? Doing::tracing : next_doing(place), place);
    }
    if (doing_ == Doing::off) return let_go(place);
    hold(place, grip_);
    if (place.hand.has_arrived(place.awake_s)) go_on(place);
}

SimVisitor::Doing SimVisitor::next_doing(const VisitorPlace& place) {
    if (!place.felt || place.felt->outlines.empty()) return Doing::wandering;
    const double share = dice_.share();
    if (share < 0.52) return Doing::tracing;
    if (share < 0.64) return Doing::tapping;
    if (share < 0.74) return Doing::pushing;
    if (share < 0.80) return Doing::jerking;
    if (share < 0.88) return Doing::wandering;
    return share < 0.95 ? Doing::resting : Doing::off;
}

void SimVisitor::begin(Doing doing, const VisitorPlace& place) {
    doing_ = doing;
    const bool has_lines = place.felt && !place.felt->outlines.empty();
    if (!has_lines) return;
    outline_ = dice_.below(place.felt->outlines.size());
    point_ = dice_.below(place.felt->outlines[outline_].points.size());
}

/// Starts the next stretch of what the hand does.
void SimVisitor::go_on(const VisitorPlace& place) {
    const bool has_lines = place.felt && outline_ < place.felt->outlines.size();
    const double calm_m_per_s = dice_.between(0.02, 0.12);
    if (!has_lines || doing_ == Doing::wandering)
        return place.hand.go(somewhere(half_width_m, half_height_m), calm_m_per_s, place.awake_s);
    const std::vector<Position>& points = place.felt->outlines[outline_].points;
    const Position on = points[point_ % points.size()];
    switch (doing_) {
        case Doing::tracing:
            ++point_;
            return place.hand.go(on, calm_m_per_s, place.awake_s);
        case Doing::tapping:
            is_tap_down_ = !is_tap_down_;
            return place.hand.go(is_tap_down_ ? on : on + somewhere(tap_m, tap_m), 0.15,
                                 place.awake_s);
        case Doing::pushing:
            return place.hand.go(on + somewhere(pushed_m, pushed_m), 0.06, place.awake_s);
        case Doing::jerking:
            return place.hand.go(somewhere(half_width_m, half_height_m), dice_.between(0.3, 1.1),
                                 place.awake_s);
        case Doing::wandering:
        case Doing::resting:
        case Doing::off:
            return;
    }
}

std::optional<KeyRole> SimVisitor::key(const VisitorPlace& place) {
    if (place.now_s < next_key_s_) return std::nullopt;
    next_key_s_ = place.now_s + pace_s_ * dice_.between(0.5, 2.0);
    const VisitScreen screen = open_screen(place.kiosk.visit());
    if (screen == VisitScreen::goodbye || screen == VisitScreen::closed) return std::nullopt;
    if (dice_.is_hit(0.06)) return static_cast<KeyRole>(dice_.below(key_role_count));
    return key_of_screen(place, screen);
}

KeyRole SimVisitor::key_of_screen(const VisitorPlace& place, VisitScreen screen) {
    const bool is_going = is_leaving(place.now_s);
    const auto towards = [&place](VisitItem item) {
        const SpokenScreen shown = place.kiosk.screen();
        return id_of_focus(shown) == static_cast<int>(item) ? KeyRole::select : KeyRole::down;
    };
    switch (screen) {
        case VisitScreen::choose:
            if (is_going) return towards(VisitItem::finish);
            return dice_.is_hit(0.03) ? KeyRole::select : towards(wish_);
        case VisitScreen::confirm:
            return towards(is_going ? VisitItem::yes : VisitItem::no);
        case VisitScreen::camera:
            return is_going ? KeyRole::back : towards(VisitItem::take_picture);
        case VisitScreen::gallery:
        case VisitScreen::stick:
            if (is_going) return KeyRole::back;
            return dice_.is_hit(0.3) ? KeyRole::select : KeyRole::down;
        case VisitScreen::help:
            return KeyRole::back;  // pressed twice it leads out; other keys only explain themselves
        case VisitScreen::opening:
            return dice_.is_hit(0.05) ? KeyRole::select : KeyRole::repeat;
        case VisitScreen::practice:
        case VisitScreen::picture:
        case VisitScreen::parts:
        case VisitScreen::explore:
        case VisitScreen::zoom:
        case VisitScreen::pages:
        case VisitScreen::settings:
        case VisitScreen::values:
            return is_going ? KeyRole::back : key_while_feeling(place);
        default:
            return KeyRole::select;  // for anything else it asks or says
    }
}

/// A visitor who wants a sheet goes straight to it, once.
std::optional<KeyRole> SimVisitor::key_to_sheet(const VisitorPlace& place) const {
    const Visitor& visitor = place.kiosk.visit().visitor;
    if (!visit_.prints || visitor.sheets > 0 || visitor.awaits_sheet) return std::nullopt;
    const SpokenScreen shown = place.kiosk.screen();
    constexpr int sheet = static_cast<int>(VisitItem::print_sheet);
    if (std::ranges::find(shown.items, sheet, &ScreenItem::id) == shown.items.end())
        return std::nullopt;
    return id_of_focus(shown) == sheet ? KeyRole::select : KeyRole::down;
}

/// A feeling visitor presses few keys, and now and then wants another picture.
KeyRole SimVisitor::key_while_feeling(const VisitorPlace& place) {
    if (const auto key = key_to_sheet(place)) return *key;
    next_key_s_ = place.now_s + dice_.between(1.0, 12.0);
    const double share = dice_.share();
    if (share < 0.5) return KeyRole::down;
    if (share < 0.82) return KeyRole::select;
    if (share < 0.9) return KeyRole::up;
    if (share < 0.96) return KeyRole::back;
    if (dice_.is_hit(0.3)) {
        constexpr std::array wishes{VisitItem::practise, VisitItem::gallery, VisitItem::stick,
                                    VisitItem::camera};
        wish_ = wishes.at(dice_.below(wishes.size()));
    }
    return KeyRole::repeat;
}

}  // namespace touchline
