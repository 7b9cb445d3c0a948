#include "haptics/contact/contact_machine.h"

#include "haptics/contact/contact_step.h"
#include "haptics/contact/wall_motion.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// What a step may still need to return once late, and the first one on a scene, which finds neither
// data nor code in any cache.
constexpr std::int64_t return_ns = 3000;
constexpr std::int64_t cold_return_ns = 6500;

constexpr double octave_s = 0.05;         // a change of level that is hindered takes so long
constexpr double largest_push_N = 0.015;  // of a moving wall in a tick

/// Beyond the coarsest level nothing changes any more.
double bounded(const Scene& scene, double level) {
    if (!(level > 0.0)) return 0.0;
    return std::min(level, static_cast<double>(scene.curves.coarsest()));
}

}  // namespace

void ContactMachine::reset(const Scene& scene, Position handle, double level) {
    outlines_ = RenderedOutlines(scene, bounded(scene, level));
    proxy_ = {};
    proxy_.centre = handle;
    handle_ = handle;
    radius_m_ = 0.0;
    account_ = {};
    pace_octaves_ = largest_octaves;
    groove_ = {};
    is_fresh_ = true;
    // Nearer than the skin to a line: onto its left. A second line as near is met at the next
    // round.
    for (int i = 0; i < 8 && is_finite(handle); ++i) {
        const Closest at = scene.tree.closest_point(scene.curves, proxy_.centre, outlines_.level(),
                                                    contact_skin_m);
        if (at.segment.piece < 0) return;
        const Segment s = outlines_.segment(at.segment);
        const Position away = proxy_.centre - at.point;
        const Direction out = norm(away) > approach_tolerance_m ? direction_of(away)
                                                                : left_of(direction_of(s.b - s.a));
        proxy_.centre = at.point + along<Position>(out, contact_skin_m);
    }
}

ContactReport ContactMachine::step(Position handle, double level, const ContactSettings& settings,
                                   const Budget& budget, double dt_s) {
    ContactReport report;
    report.transitions = StateTrail(proxy_.state);
    report.p_WP = proxy_.centre;
    report.level = outlines_.level();
    if (path_ != nullptr) path_->clear();
    const bool is_usable = outlines_.has_scene() && is_finite(handle) && std::isfinite(level) &&
                           std::isfinite(settings.stiffness_N_per_m) &&
                           std::isfinite(settings.friction) && std::isfinite(settings.radius_m) &&
                           dt_s > 0.0;
    if (!is_usable) return report;
    if (!is_finite(proxy_.centre)) reset(outlines_.scene(), handle, level);
    if (settings.mode != mode_ && settings.mode == Mode::wall) {
        reset(outlines_.scene(), handle, outlines_.level());
    }
    mode_ = settings.mode;
    Budget left = budget;
    if (left.deadline_ns != 0) left.deadline_ns -= is_fresh_ ? cold_return_ns : return_ns;
    is_fresh_ = false;
    const double wanted = bounded(outlines_.scene(), level);
    int spent = 0;
    if (wanted != outlines_.level()) spent = change_level(wanted, handle, settings, left, dt_s);
    left.boxes -= spent;
    if (settings.mode == Mode::wall) {
        if (settings.radius_m != radius_m_) {
            const int opened = widen(settings.radius_m, left);
            left.boxes -= opened;
            spent += opened;
        }
        ContactSettings narrowed = settings;
        narrowed.radius_m = radius_m_;
        const Position start = handle - proxy_.centre;
        ContactStep(outlines_, narrowed, left, proxy_, path_).run(handle, report);
        book(handle, start, settings.stiffness_N_per_m, dt_s);
        report.force = along<Force>(proxy_.centre - handle, settings.stiffness_N_per_m);
    } else {
        hold(handle, settings, left, report);
    }
    report.boxes += spent;
    fill(report);
    return report;
}

/// A disc that overlapped a line would not be stopped by it in a corner.
int ContactMachine::widen(double wanted_m, const Budget& budget) {
    proxy_.spare_m = 0.0;
    if (wanted_m > radius_m_ && proxy_.state != ContactState::free) return 0;
    const Closest at = outlines_.scene().tree.closest_point(outlines_.scene().curves, proxy_.centre,
                                                            outlines_.level(), wanted_m, budget);
    if (wanted_m > radius_m_ && !at.is_complete) return at.boxes;
    radius_m_ = at.segment.piece < 0 ? wanted_m : std::min(wanted_m, at.distance_m);
    return at.boxes;
}

/// What the proxy's move took from the spring, less what a sampled spring may give back at the next
/// move of the hand.
void ContactMachine::book(Position handle, Position start, double stiffness_N_per_m, double dt_s) {
    const Position rest = handle - proxy_.centre;
    const Position moved = handle - handle_;
    handle_ = handle;
    const double square_m2 = dot(start, start) - dot(rest, rest) - dot(moved, moved);
    account_.earn(0.5 * stiffness_N_per_m * square_m2, dt_s);
}

/// Groove, ridge, stay: the proxy is the attachment.
void ContactMachine::hold(Position handle, const ContactSettings& settings, const Budget& budget,
                          ContactReport& report) {
    const GrooveForce held =
        groove_step(outlines_.scene(), outlines_.level(), handle, settings, budget, groove_);
    proxy_ = {};
    proxy_.centre = held.attachment;
    report.force = held.force;
    report.boxes = held.boxes;
    report.clear = held.is_complete ? 1.0 : 0.0;
    if (groove_.segment.piece >= 0) {
        proxy_.state = ContactState::edge;
        proxy_.contact_count = 1;
        proxy_.contacts[0].segment = groove_.segment;
        proxy_.contacts[0].parameter = groove_.parameter;
        proxy_.contacts[0].side = held.side;
    }
    report.transitions.add(proxy_.state);
}

int ContactMachine::change_level(double level, Position handle, const ContactSettings& settings,
                                 const Budget& budget, double dt_s) {
    int boxes = 0;
    bool is_at_once = settings.mode != Mode::wall;
    if (!is_at_once && proxy_.state == ContactState::free) {
        const double radius = std::max(settings.radius_m, contact_skin_m);
        const Scene& scene = outlines_.scene();
        const Clearance found = scene.tree.clearance(scene.curves, proxy_.centre, radius,
                                                     std::max(level, outlines_.level()), budget);
        boxes = found.boxes;
        is_at_once = found.is_clear;
    }
    if (!is_at_once) {
        const Budget left{budget.boxes - boxes, budget.deadline_ns};
        return boxes + move_wall(level, handle, settings, left, dt_s);
    }
    outlines_ = RenderedOutlines(outlines_.scene(), level);
    proxy_.spare_m = 0.0;
    groove_ = {};
    return boxes;
}

/// Towards `level`, not over a whole level, by one try a tick: as far as pushes the hand by no more
/// than a touch of force, as the tick before has found; a little way after one that found no place.
int ContactMachine::move_wall(double level, Position handle, const ContactSettings& settings,
                              const Budget& budget, double dt_s) {
    const double from = outlines_.level();
    const double stop = level > from ? std::floor(from) + 1.0 : std::ceil(from) - 1.0;
    const double goal = level > from ? std::min(level, stop) : std::max(level, stop);
    const bool is_whole_way = pace_octaves_ >= std::abs(goal - from);
    const double to = is_whole_way ? goal : from + std::copysign(pace_octaves_, goal - from);
    WallMotion motion(outlines_, to, settings.radius_m, budget);
    const auto carried = motion.carry(proxy_, handle);
    if (!carried) {
        pace_octaves_ = std::min(dt_s / octave_s, largest_octaves);
        return motion.boxes();
    }
    const double push_N = settings.stiffness_N_per_m * carried->moved_m;
    if (push_N <= largest_push_N) {
        adopt(*carried, motion.after(), handle, settings.stiffness_N_per_m);
        pace_octaves_ = std::min(2.0 * pace_octaves_, largest_octaves);
    } else {
        pace_octaves_ = 0.95 * std::abs(to - from) * largest_push_N / push_N;
    }
    return motion.boxes();
}

/// Unless the wall would do work on the hand that is not covered.
void ContactMachine::adopt(const Carried& carried, const RenderedOutlines& outlines,
                           Position handle, double stiffness_N_per_m) {
    const Position before = handle - proxy_.centre;
    const Position after = handle - carried.proxy.centre;
    const double work_J = 0.5 * stiffness_N_per_m * (dot(after, after) - dot(before, before));
    if (!account_.spend(work_J)) return;
    proxy_ = carried.proxy;
    outlines_ = outlines;
}

void ContactMachine::fill(ContactReport& report) const {
    report.p_WP = proxy_.centre;
    report.state = proxy_.state;
    report.level = outlines_.level();
    if (proxy_.state == ContactState::free) return;
    const Contact& at = proxy_.contacts[0];
    const CurveSet& curves = outlines_.scene().curves;
    report.level = curves.rendered_level(at.segment.piece, outlines_.level());
    report.outline = curves.pieces()[static_cast<std::size_t>(at.segment.piece)].outline;
    report.parameter = curves.outline_parameter(at.segment.piece, outlines_.level(),
                                                at.segment.index, at.parameter);
    report.side = at.side;
}

}  // namespace touchline
