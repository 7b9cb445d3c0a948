#include "haptics/contact/contact_machine.h"
#include "haptics/contact/contact_step.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double least_sine = 1e-3;  // of two lines that meet in a point worth the name

LevelChange change_between(double from, double to) {
    const double low = std::min(from, to);
    const auto finer = static_cast<int>(low);
    return {finer, from - finer, to - finer};
}

}  // namespace

MovingWall::MovingWall(const RenderedOutlines& outlines, double to, double radius_m,
                       const Budget& budget)
    : before_(outlines),
      after_(outlines.scene(), to),
      change_(change_between(outlines.level(), to)),
      radius_m_(std::max(radius_m, contact_skin_m)),
      budget_(budget) {}

/// How far the motion takes the proxy, by itself and by the slide along an edge to the handle's
/// foot that follows it.
double MovingWall::way_m(const ProxyState& from, const ProxyState& to) const {
    const double carried_m = norm(to.centre - from.centre);
    const auto foot_of = [&](const ProxyState& at) {
        if (at.state != ContactState::edge) return at.centre;
        const Direction n = at.contacts[0].normal;
        return handle_ + along<Position>(n, dot(at.centre - handle_, n));
    };
    return std::max(carried_m, norm(foot_of(to) - foot_of(from)));
}

std::optional<Carried> MovingWall::carry(const ProxyState& proxy, Position handle,
                                         const WallAllowance& allowance) {
    handle_ = handle;
    allowance_ = allowance;
    std::optional<Carried> found;
    if (proxy.contact_count == 0) {
        found = carry_free(proxy);
    } else if (proxy.contact_count == 2) {
        found = carry_corner(proxy);
    } else {
        found = proxy.contacts[0].is_round ? carry_round(proxy) : carry_edge(proxy);
    }
    if (found) found->proxy.spare_m = 0.0;
    if (found) found->proxy.left = {};
    return found;
}

/// What it does to the hand that the wall takes the proxy along.
Carried MovingWall::effect(const ProxyState& from, const ProxyState& to) const {
    const Position before = handle_ - from.centre;
    const Position after = handle_ - to.centre;
    const double push_N = allowance_.stiffness_N_per_m * way_m(from, to);
    const double work_J =
        0.5 * allowance_.stiffness_N_per_m * (dot(after, after) - dot(before, before));
    const bool is_allowed = push_N <= allowance_.push_N && work_J <= allowance_.work_J;
    return {to, push_N, work_J, is_allowed};
}

/// Whether the way is free is asked only if the place is allowed.
std::optional<Carried> MovingWall::reached(const ProxyState& from, const ProxyState& to,
                                           const Edges& own) {
    const Carried found = effect(from, to);
    if (found.is_allowed && !is_way_free(from.centre, to.centre, own)) return {};
    return found;
}

std::optional<Carried> MovingWall::carry_free(const ProxyState& proxy) {
    const WallHit hit = first_wall(proxy.centre, {});
    if (is_cut_) return {};
    return hit.is_hit ? pushed(proxy, hit) : Carried{proxy};
}

/// A wall that reaches a free proxy takes it along, on the side where it lay.
std::optional<Carried> MovingWall::pushed(const ProxyState& proxy, const WallHit& hit) {
    Contact at;
    at.segment = hit.segment;
    at.parameter = hit.parameter;
    at.side = hit.was_left ? Side::left : Side::right;
    at.offset_m = contact_skin_m;
    at = joined(at);
    const Segment s = after_.segment(at.segment);
    at.normal = normal_of(s, at.side);
    ProxyState next = proxy;
    next.state = ContactState::edge;
    next.contacts[0] = at;
    next.contact_count = 1;
    next.centre = centre_of(s, at);
    const Excluded halves{hit.segment};
    // First the proxy goes ahead of the wall, which is not there yet; then the wall follows.
    const bool is_ok =
        is_free(before_, proxy.centre, next.centre, {}) && !is_swept(next.centre, halves);
    return is_ok ? std::optional(effect(proxy, next)) : std::nullopt;
}

std::optional<Carried> MovingWall::carry_edge(const ProxyState& proxy) {
    const Contact half = halved(proxy.contacts[0]);
    Contact at = joined(half);
    const Segment s = after_.segment(at.segment);
    at.normal = normal_of(s, at.side);
    ProxyState next = proxy;
    next.contacts[0] = at;
    next.centre = centre_of(s, at);
    return reached(proxy, next, {{proxy.contacts[0].segment}, {half.segment}, {at.segment}});
}

/// Round a vertex the normal stays as it is while it lies in the arc between the edges' normals;
/// else the edge under the proxy carries it. An edge is left out of the tests only if the new place
/// lies on its right side by construction.
std::optional<Carried> MovingWall::carry_round(const ProxyState& proxy) {
    const Contact& old = proxy.contacts[0];
    const Contact half = halved(old);
    const bool at_end = half.parameter > 0.5;
    Contact at = joined(half);
    const Joint joint = joint_of(at, at_end);
    if (!joint.is_convex || !joint.holds(at.normal)) {
        ProxyState on_edge = proxy;
        on_edge.contacts[0].is_round = false;
        on_edge.state = ContactState::edge;
        return carry_edge(on_edge);
    }
    ProxyState next = proxy;
    next.contacts[0] = at;
    next.centre = centre_of(after_.segment(at.segment), at);
    const SegmentRef beside = before_.next(old.segment, at_end);
    SegmentRef half_beside = beside;
    if (beside.piece >= 0) {
        half_beside =
            halved({beside, at_end ? 0.0 : 1.0, old.side, old.normal, old.offset_m, false}).segment;
    }
    return reached(
        proxy, next,
        {{old.segment, beside}, {half.segment, half_beside}, {at.segment, joint.beside}});
}

/// The two edges at a contact's end after the motion.
MovingWall::Joint MovingWall::joint_of(const Contact& at, bool at_end) {
    Joint joint;
    if (at.parameter != 0.0 && at.parameter != 1.0) return joint;  // not a vertex any more
    const Segment s = after_.segment(at.segment);
    joint.beside = after_.next(at.segment, at_end);
    joint.own = normal_of(s, at.side);
    joint.outward = (at_end ? 1.0 : -1.0) * direction_of(s.b - s.a);
    joint.other =
        joint.beside.piece < 0 ? -joint.own : normal_of(after_.segment(joint.beside), at.side);
    joint.is_convex = joint.beside.piece < 0 || dot(joint.other, joint.outward) > 0.0;
    return joint;
}

bool MovingWall::Joint::holds(Direction normal) const {
    const bool is_outward = dot(normal, outward) >= 0.0;
    return is_outward && (beside.piece < 0 || cross(own, other) * cross(normal, other) >= 0.0);
}

/// Held by two edges: goes to where the lines at the proxy's distance from both cross after the
/// motion, on the same sides. If that place lies on neither edge any more, one of them carries the
/// proxy on.
std::optional<Carried> MovingWall::carry_corner(const ProxyState& proxy) {
    const bool is_edges = !proxy.contacts[0].is_round && !proxy.contacts[1].is_round;
    if (is_edges) {
        const auto corner = carry_between(proxy);
        if (corner) return corner;
    }
    ProxyState single = proxy;
    single.contact_count = 1;
    if (single.contacts[0].is_round && !single.contacts[1].is_round) {
        single.contacts[0] = single.contacts[1];
    }
    if (single.contacts[0].is_round) return carry_round(single);
    single.state = ContactState::edge;
    return carry_edge(single);
}

std::optional<Carried> MovingWall::carry_between(const ProxyState& proxy) {
    ProxyState next = proxy;
    Edges own;
    std::array<Segment, 2> s;
    for (std::size_t i = 0; i < 2; ++i) {
        const Contact half = halved(proxy.contacts[i]);
        Contact& at = next.contacts[i];
        at = joined(half);
        s[i] = after_.segment(at.segment);
        at.normal = normal_of(s[i], at.side);
        own.before[i] = proxy.contacts[i].segment;
        own.halves[i] = half.segment;
        own.after[i] = at.segment;
    }
    Contact& a = next.contacts[0];
    Contact& b = next.contacts[1];
    const double sine = cross(a.normal, b.normal);
    if (a.segment == b.segment || !(std::abs(sine) > least_sine)) return {};
    const Position on_a = s[0].a + along<Position>(a.normal, a.offset_m);
    const Position on_b = s[1].a + along<Position>(b.normal, b.offset_m);
    const double way_m = dot(on_b - on_a, b.normal) / sine;
    next.centre = on_a + along<Position>(left_of(a.normal), way_m);
    for (std::size_t i = 0; i < 2; ++i) {
        Contact& at = next.contacts[i];
        const Position on_line = next.centre - along<Position>(at.normal, at.offset_m);
        const Foot on_segment = foot(on_line, s[i]);
        if (!(on_segment.distance_m <= contact_skin_m)) return {};
        at.parameter = on_segment.parameter;
    }
    return reached(proxy, next, own);
}

/// Either the proxy goes first and the walls follow, or the other way round: both must bring it to
/// the same side of everything. Its own edges stay beside it all the way.
bool MovingWall::is_way_free(Position from, Position to, const Edges& own) {
    if (is_alone(own.halves)) return is_way_free_alone(from, to, own);
    if (is_free(before_, from, to, own.before) && !is_swept(to, own.halves)) return true;
    return !is_swept(from, own.halves) && is_free(after_, from, to, own.after);
}

/// The same where only the neighbours along the outline come near.
bool MovingWall::is_way_free_alone(Position from, Position to, const Edges& own) {
    if (is_free_alone(before_, from, to, own.before) && !is_swept_alone(to, own.halves))
        return true;
    return !is_swept_alone(from, own.halves) && is_free_alone(after_, from, to, own.after);
}

/// Whether the nodes that hold the edges at every level of the octave are alone. The proxy stays
/// within its radius of their boxes all the way, since both its places do.
bool MovingWall::is_alone(const Excluded& halves) const {
    const Scene& scene = before_.scene();
    for (const SegmentRef& half : halves) {
        if (half.piece < 0) continue;
        const NodeRange nodes = CollisionTree::nodes(scene.curves, half.piece, change_.finer + 0.5);
        const int node = nodes.is_blend ? half.index / 2 : half.index;
        if (!scene.tree.is_alone(nodes.first + static_cast<std::size_t>(node))) return false;
    }
    return true;
}

bool MovingWall::is_free(RenderedOutlines& at, Position from, Position to,
                         const Excluded& excluded) {
    const Motion motion{from, to, contact_skin_m, at.level(), excluded};
    const Hit hit = at.scene().tree.first_hit(at.scene().curves, motion, budget_);
    budget_.boxes -= hit.boxes;
    boxes_ += hit.boxes;
    return !hit.is_hit && hit.clear >= 1.0;
}

bool MovingWall::is_swept(Position p, const Excluded& halves) {
    const WallHit hit = first_wall(p, halves);
    return is_cut_ || hit.is_hit;
}

bool MovingWall::is_free_alone(RenderedOutlines& at, Position from, Position to,
                               const Excluded& excluded) {
    bool is_met = false;
    const auto next = [&](SegmentRef ref, bool is_forward) { return at.next(ref, is_forward); };
    visit_beside(excluded, halves_beside, next, [&](SegmentRef ref) {
        is_met = is_met || touch(from, to, contact_skin_m, at.segment(ref)).has_value();
    });
    return !is_met;
}

bool MovingWall::is_swept_alone(Position p, const Excluded& halves) const {
    const CurveSet& curves = before_.scene().curves;
    int piece = -1;  // whose these are:
    RenderedPiece from;
    RenderedPiece to;
    bool is_met = false;
    const auto next = [&](SegmentRef ref, bool is_forward) {
        return is_forward ? curves.next(ref, change_.finer) : curves.previous(ref, change_.finer);
    };
    visit_beside(halves, halves_beside, next, [&](SegmentRef ref) {
        if (ref.piece != piece) {
            piece = ref.piece;
            from = curves.blend(piece, change_.finer, change_.from);
            to = curves.blend(piece, change_.finer, change_.to);
        }
        is_met = is_met || meeting(p, from.segment(ref.index), to.segment(ref.index)).has_value();
    });
    return is_met;
}

WallHit MovingWall::first_wall(Position p, const Excluded& halves) {
    const Scene& scene = before_.scene();
    const WallHit hit = scene.tree.first_wall(scene.curves, p, change_, halves, budget_);
    budget_.boxes -= hit.boxes;
    boxes_ += hit.boxes;
    is_cut_ = is_cut_ || !hit.is_complete;
    return hit;
}

/// True if a half is one of the two that make a segment of the coarser level.
bool MovingWall::is_pair(SegmentRef half) const {
    const CurveSet& curves = before_.scene().curves;
    return (half.index | 1) < curves.segment_count(half.piece, change_.finer);
}

/// A contact at the level before, in segments of the octave's finer level.
Contact MovingWall::halved(Contact contact) const {
    const CurveSet& curves = before_.scene().curves;
    const int coarsest = curves.piece(contact.segment.piece).coarsest;
    if (change_.finer >= coarsest || change_.from < 1.0) return contact;
    contact.segment.index *= 2;
    if (!is_pair(contact.segment)) return contact;
    const bool is_second = contact.parameter >= 0.5;
    contact.segment.index += is_second ? 1 : 0;
    contact.parameter = 2.0 * contact.parameter - (is_second ? 1.0 : 0.0);
    return contact;
}

/// Converts back, at the level after.
Contact MovingWall::joined(Contact half) const {
    const CurveSet& curves = before_.scene().curves;
    const int coarsest = curves.piece(half.segment.piece).coarsest;
    if (change_.finer >= coarsest || change_.to < 1.0) return half;
    if (is_pair(half.segment)) half.parameter = 0.5 * (half.parameter + (half.segment.index % 2));
    half.segment.index /= 2;
    return half;
}

}  // namespace touchline
