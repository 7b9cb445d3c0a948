#include "haptics/probe/held_shapes.h"

#include <utility>
#include <vector>

namespace touchline {
namespace {

constexpr double disc_radius_m = 4e-3;
constexpr double corner_radius_m = 5e-4;  // rounds a corner, so that it does not catch on a line's

ProbeShape rounded(const Outline& outline, Position held_at) {
    std::vector<Segment> edges = probes::edges_of(outline);
    for (Segment& edge : edges) edge = {edge.a - held_at, edge.b - held_at};
    return *ProbeShape::build(std::move(edges), corner_radius_m);
}

}  // namespace

ProbeShape held_shape(HeldShape shape) {
    switch (shape) {
        case HeldShape::none:
            break;
        case HeldShape::disc:
            return probes::disc(disc_radius_m);
        case HeldShape::bar:
            return rounded(probes::bar(0.018, 0.004), {});
        case HeldShape::ell:
            return rounded(probes::ell(0.014, 0.004), {0.004, 0.004});
        case HeldShape::key:
            return rounded(probes::key(0.022), {0.007, 0.0});
    }
    return probes::disc(0.0);
}

ContactReport contact_of(const ProbeReport& report, const CurveSet& curves) {
    ContactReport contact;
    contact.force = report.force;
    contact.stored_J = report.stored_J;
    contact.p_WP = report.pose.place();
    contact.state = report.state;
    contact.level = report.level;
    contact.transitions = report.transitions;
    contact.carried_m = report.carried_m;
    contact.boxes = report.boxes;
    contact.clear = report.clear;
    if (report.contact_count == 0) return contact;
    const ProbeContact& first = report.contacts[0];
    contact.piece = first.segment.piece;
    contact.outline = curves.piece(contact.piece).outline;
    contact.parameter =
        curves.outline_parameter(contact.piece, report.level, first.segment.index, first.parameter);
    contact.side = first.side;
    return contact;
}

}  // namespace touchline
