#include "haptics/contact/event_detector.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double clear_side_m = 3e-4;
constexpr double area_margin_m = 1e-3;

ContactEvent event_of(ContactEventKind kind, const EventInput& input) {
    const ContactReport& contact = input.contact;
    const bool is_area =
        kind == ContactEventKind::area_entered || kind == ContactEventKind::area_left;
    return {kind,
            input.time_s,
            is_area ? input.p_WH : contact.p_WP,
            contact.outline,
            contact.parameter,
            input.rendered_level,
            input.scene->map_version};
}

double beyond_m(Position p, const Area& area) {
    return std::max(std::abs(p.x) - 0.5 * area.width_m, std::abs(p.y) - 0.5 * area.height_m);
}

bool is_nearer_to_start(const CurveSet& curves, const ContactReport& contact) {
    const double along = contact.parameter - curves.piece(contact.piece).first_parameter;
    return along < 0.5 * curves.segment_count(contact.piece, 0);
}

}  // namespace

TickEvents EventDetector::step(const EventInput& input) {
    TickEvents events;
    if (is_first_) {
        level_.take(input.rendered_level);
        is_inside_.take(!(beyond_m(input.p_WH, input.scene->area) > 0.0));
        is_first_ = false;
    }
    if (input.contact.has_popped) events.add(event_of(ContactEventKind::popped_through, input));
    tell_contact(input, events);
    tell_places(input, events);
    tell_area(input, events);
    const bool is_whole = input.rendered_level == std::floor(input.rendered_level);
    if (level_.update(is_whole ? input.rendered_level : level_.told(), input.time_s)) {
        events.add(event_of(ContactEventKind::level_changed, input));
    }
    return events;
}

void EventDetector::tell_contact(const EventInput& input, TickEvents& events) {
    const bool is_touching = input.contact.state != ContactState::free;
    if (is_touching_.update(is_touching, input.time_s)) {
        events.add(event_of(
            is_touching ? ContactEventKind::contact_made : ContactEventKind::contact_lost, input));
    }
    const int before = outline_.told();
    change_.watch(input.p_WH);
    const bool is_heard = is_touching && !change_.is_told();
    if (!outline_.update(is_heard ? input.contact.outline : before, input.time_s)) return;
    if (before >= 0 && change_.tell(input.p_WH, input.time_s)) {
        events.add(event_of(ContactEventKind::outline_changed, input));
    }
}

void EventDetector::tell_places(const EventInput& input, TickEvents& events) {
    const ContactReport& contact = input.contact;
    const Position p = input.p_WH;
    for (Place* const place : {&vertex_, &crossing_}) place->watch(p);
    if (!contact.is_at_end) end_.watch(p);
    const bool is_same = contact.outline >= 0 && contact.outline == last_outline_;
    if (is_same && has_passed_corner(input) && vertex_.tell(p, input.time_s)) {
        events.add(event_of(ContactEventKind::vertex_passed, input));
    }
    if (contact.is_at_end && end_.tell(p, input.time_s)) {
        ContactEvent event = event_of(ContactEventKind::end_reached, input);
        if (contact.outline < 0) event.outline = last_outline_;  // slid off it
        events.add(event);
    }
    const bool is_held = input.mode != Mode::wall && contact.outline >= 0;
    const bool is_taken_over = is_held && last_outline_ >= 0 && !is_same;
    if (!is_held || is_taken_over) side_ = 0;
    const bool is_clear = is_held && !contact.is_at_end && norm(p - contact.p_WP) > clear_side_m;
    const int side = is_clear ? static_cast<int>(contact.side) : side_;
    const bool is_crossed = side_ != 0 && side != side_;
    side_ = side;
    if ((is_crossed || is_taken_over) && crossing_.tell(p, input.time_s)) {
        events.add(event_of(ContactEventKind::line_crossed, input));
    }
    last_outline_ = contact.outline;
    last_piece_ = contact.piece;
    last_parameter_ = contact.parameter;
}

/// True on a change into another piece, or round a loop of a single piece past its one pin; by the
/// piece's nearer end.
bool EventDetector::has_passed_corner(const EventInput& input) const {
    const ContactReport& contact = input.contact;
    const CurveSet& curves = input.scene->curves;
    const Piece& piece = curves.piece(contact.piece);
    const bool is_round =
        piece.next == contact.piece && std::abs(contact.parameter - last_parameter_) >
                                           0.5 * curves.segment_count(contact.piece, 0);
    if (contact.piece == last_piece_ && !is_round) return false;
    if (is_nearer_to_start(curves, contact)) return piece.starts_at_corner;
    return piece.next < 0 || curves.piece(piece.next).starts_at_corner;
}

/// The area is left when the hand is 1 mm outside, and entered when it is 1 mm inside.
void EventDetector::tell_area(const EventInput& input, TickEvents& events) {
    const double out_m = beyond_m(input.p_WH, input.scene->area);
    const bool is_inside = is_inside_.told() ? out_m <= area_margin_m : out_m <= -area_margin_m;
    if (!is_inside_.update(is_inside, input.time_s)) return;
    events.add(
        event_of(is_inside ? ContactEventKind::area_entered : ContactEventKind::area_left, input));
}

}  // namespace touchline
