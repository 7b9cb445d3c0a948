#include "haptics/contact/contact_machine.h"

#include "haptics/contact/contact_step.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// What a step may still need to return once late, and the first one on a scene, which finds neither
// data nor code in any cache.
constexpr std::int64_t return_ns = 3000;
constexpr std::int64_t cold_return_ns = 6500;

}  // namespace

void ContactMachine::reset(const Scene& scene, Position handle, double level) {
    outlines_ = RenderedOutlines(scene, std::max(level, 0.0));
    proxy_ = {};
    proxy_.centre = handle;
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
                                   const Budget& budget) {
    ContactReport report;
    report.transitions = StateTrail(proxy_.state);
    report.p_WP = proxy_.centre;
    report.level = outlines_.level();
    if (path_ != nullptr) path_->clear();
    const bool is_usable = outlines_.has_scene() && is_finite(handle) && std::isfinite(level) &&
                           std::isfinite(settings.stiffness_N_per_m) &&
                           std::isfinite(settings.friction) && std::isfinite(settings.radius_m);
    if (!is_usable) return report;
    if (settings.mode != mode_ && settings.mode == Mode::wall) {
        reset(outlines_.scene(), handle, outlines_.level());
    }
    mode_ = settings.mode;
    if (settings.radius_m != radius_m_) proxy_.spare_m = 0.0;
    radius_m_ = settings.radius_m;
    const double wanted = std::max(level, 0.0);
    const int spent = wanted == outlines_.level() ? 0 : adopt_level(wanted, settings, budget);
    Budget left{budget.boxes - spent, budget.deadline_ns};
    if (left.deadline_ns != 0) left.deadline_ns -= is_fresh_ ? cold_return_ns : return_ns;
    is_fresh_ = false;
    if (settings.mode == Mode::wall) {
        ContactStep(outlines_, settings, left, proxy_, path_).run(handle, report);
        report.force = along<Force>(proxy_.centre - handle, settings.stiffness_N_per_m);
    } else {
        hold(handle, settings, left, report);
    }
    report.boxes += spent;
    fill(report);
    return report;
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

int ContactMachine::adopt_level(double level, const ContactSettings& settings,
                                const Budget& budget) {
    const double now = outlines_.level();
    const bool is_wall = settings.mode == Mode::wall;
    if (is_wall && proxy_.state != ContactState::free) return 0;
    Clearance found{true, 0};
    if (is_wall) {
        const double radius = std::max(settings.radius_m, contact_skin_m);
        found = outlines_.scene().tree.clearance(outlines_.scene().curves, proxy_.centre, radius,
                                                 std::max(level, now), budget);
    }
    if (found.is_clear) {
        outlines_ = RenderedOutlines(outlines_.scene(), level);
        proxy_.spare_m = 0.0;
        groove_ = {};
    }
    return found.boxes;
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
