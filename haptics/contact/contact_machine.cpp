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
    adopt_level(std::max(level, 0.0), settings);
    if (settings.mode == Mode::wall) {
        path_size_ =
            ContactStep(*scene_, level_, settings, budget, proxy_, path_).run(handle, report);
        report.force = along<Force>(proxy_.centre - handle, settings.stiffness_N_per_m);
    } else {
        const GrooveForce held = groove_step(*scene_, level_, handle, settings, groove_);
        const bool is_attached = groove_.segment.piece >= 0;
        proxy_ = {};
        proxy_.centre = held.attachment;
        report.force = held.force;
        report.boxes = held.boxes;
        if (is_attached) {
            proxy_.state = ContactState::edge;
            proxy_.contact_count = 1;
            proxy_.contacts[0].segment = groove_.segment;
            proxy_.contacts[0].parameter = groove_.parameter;
        }
        if (report.transitions[0] != proxy_.state) {
            report.transitions[1] = proxy_.state;
            report.transition_count = 2;
        }
    }
    fill(report);
    return report;
}

void ContactMachine::adopt_level(double level, const ContactSettings& settings) {
    if (level == level_) return;
    const double radius = std::max(settings.radius_m, contact_skin_m);
    const bool is_free =
        proxy_.state == ContactState::free &&
        scene_->tree.is_clear(scene_->curves, proxy_.centre, radius, std::max(level, level_));
    if (settings.mode == Mode::wall && !is_free) return;
    level_ = level;
    groove_ = {};
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
