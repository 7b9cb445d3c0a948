#include "haptics/contact/contact_machine.h"

#include "haptics/contact/contact_step.h"

#include <algorithm>
#include <cmath>

namespace touchline {

void ContactMachine::reset(const Scene& scene, Position handle, double level) {
    scene_ = &scene;
    proxy_ = {};
    proxy_.centre = handle;
    groove_ = {};
    level_ = std::max(level, 0.0);
    path_size_ = 0;
    // Nearer than the skin to a line: onto its left. A second line as near is met at the next
    // round.
    for (int i = 0; i < 8 && is_finite(handle); ++i) {
        const Closest at =
            scene.tree.closest_point(scene.curves, proxy_.centre, level_, contact_skin_m);
        if (at.segment.piece < 0) return;
        const Segment s = scene.curves.rendered_segment(at.segment.piece, level_, at.segment.index);
        const Position away = proxy_.centre - at.point;
        const Direction out = norm(away) > approach_tolerance_m ? direction_of(away)
                                                                : left_of(direction_of(s.b - s.a));
        proxy_.centre = at.point + along<Position>(out, contact_skin_m);
    }
}

ContactReport ContactMachine::step(Position handle, double level, const ContactSettings& settings,
                                   const Budget& budget) {
    ContactReport report;
    report.transitions[0] = proxy_.state;
    report.transition_count = 1;
    report.p_WP = proxy_.centre;
    report.level = level_;
    path_size_ = 0;
    const bool is_usable = scene_ != nullptr && is_finite(handle) && std::isfinite(level) &&
                           std::isfinite(settings.stiffness_N_per_m);
    if (!is_usable) return report;
    if (settings.mode != mode_ && settings.mode == Mode::wall) reset(*scene_, handle, level_);
    mode_ = settings.mode;
    const int spent = adopt_level(std::max(level, 0.0), settings, budget);
    const Budget left{budget.boxes - spent, budget.deadline_ns};
    if (settings.mode == Mode::wall) {
        path_size_ =
            ContactStep(*scene_, level_, settings, left, proxy_, path_).run(handle, report);
        report.force = along<Force>(proxy_.centre - handle, settings.stiffness_N_per_m);
    } else {
        const GrooveForce held = groove_step(*scene_, level_, handle, settings, left, groove_);
        const bool is_attached = groove_.segment.piece >= 0;
        proxy_ = {};
        proxy_.centre = held.attachment;
        report.force = held.force;
        report.boxes = held.boxes;
        report.clear = held.is_complete ? 1.0 : 0.0;
        if (is_attached) {
            proxy_.state = ContactState::edge;
            proxy_.contact_count = 1;
            proxy_.contacts[0].segment = groove_.segment;
            proxy_.contacts[0].parameter = groove_.parameter;
            proxy_.contacts[0].side = held.side;
        }
        if (report.transitions[0] != proxy_.state) {
            report.transitions[1] = proxy_.state;
            report.transition_count = 2;
        }
    }
    report.boxes += spent;
    fill(report);
    return report;
}

int ContactMachine::adopt_level(double level, const ContactSettings& settings,
                                const Budget& budget) {
    if (level == level_) return 0;
    if (settings.mode != Mode::wall) {
        level_ = level;
        groove_ = {};
        return 0;
    }
    if (proxy_.state != ContactState::free) return 0;
    const double radius = std::max(settings.radius_m, contact_skin_m);
    const Clearance found = scene_->tree.clearance(scene_->curves, proxy_.centre, radius,
                                                   std::max(level, level_), budget);
    if (found.is_clear) level_ = level;
    return found.boxes;
}

void ContactMachine::fill(ContactReport& report) const {
    report.p_WP = proxy_.centre;
    report.state = proxy_.state;
    report.level = level_;
    if (proxy_.state == ContactState::free) return;
    const Contact& at = proxy_.contacts[0];
    const Piece& piece = scene_->curves.pieces()[static_cast<std::size_t>(at.segment.piece)];
    report.level = scene_->curves.rendered_level(at.segment.piece, level_);
    report.outline = piece.outline;
    report.parameter =
        scene_->curves.outline_parameter(at.segment.piece, level_, at.segment.index, at.parameter);
    report.side = at.side;
}

}  // namespace touchline
