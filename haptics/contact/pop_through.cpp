#include "haptics/contact/pop_through.h"

namespace touchline {
namespace {

constexpr double longest_slide_m = 5e-4;
constexpr double least_cosine = 0.7;  // of a turn that is none: a corner turns by 45 degrees

/// Returns the edge with which the line goes on at the nearer end, if it does.
SegmentRef continuation(RenderedOutlines& outlines, const Contact& at) {
    const bool at_end = at.parameter > 0.5;
    const SegmentRef next = outlines.next(at.segment, at_end);
    if (next.piece < 0) return {};
    const Direction own =
        direction_of(outlines.segment(at.segment).b - outlines.segment(at.segment).a);
    const Segment other = outlines.segment(next);
    return dot(own, direction_of(other.b - other.a)) > least_cosine ? next : SegmentRef{};
}

/// True on an edge of one line, or where two of its edges follow each other.
bool is_on_one_line(RenderedOutlines& outlines, const ProxyState& proxy) {
    if (proxy.state == ContactState::edge) return true;
    if (proxy.state == ContactState::free) return false;
    const SegmentRef next = continuation(outlines, proxy.contacts[0]);
    return next.piece >= 0 && (proxy.contact_count == 1 || next == proxy.contacts[1].segment);
}

}  // namespace

bool PopThrough::step(RenderedOutlines& outlines, Position handle, const ContactSettings& settings,
                      const Budget& budget, double dt_s, ProxyState& proxy, int& boxes) {
    if (!(settings.pop_through_N > 0.0)) return false;
    const double push_N = settings.stiffness_N_per_m * norm(handle - proxy.centre);
    const bool is_push = push_N >= settings.pop_through_N && is_on_one_line(outlines, proxy);
    const bool is_same =
        is_push && pushed_s_ > 0.0 && norm(proxy.centre - place_) <= longest_slide_m;
    if (!is_same) place_ = proxy.centre;
    pushed_s_ = is_push ? dt_s + (is_same ? pushed_s_ : 0.0) : 0.0;
    if (!is_push || !(pushed_s_ >= settings.pop_through_s)) return false;

    const Contact& at = proxy.contacts[0];
    const Position on_line = point_of(outlines.segment(at.segment), at.parameter);
    const Position skin = along<Position>(at.normal, 2.0 * contact_skin_m);
    const Motion through{on_line + skin,
                         on_line - skin,
                         contact_skin_m,
                         outlines.level(),
                         {at.segment, continuation(outlines, at)}};
    const Hit hit = outlines.scene().tree.first_hit(outlines.scene().curves, through, budget);
    boxes += hit.boxes;
    if (hit.is_hit || hit.clear < 1.0) return false;
    proxy = {};
    proxy.centre = on_line - skin;
    pushed_s_ = 0.0;
    return true;
}

}  // namespace touchline
