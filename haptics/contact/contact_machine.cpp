#include "haptics/contact/contact_machine.h"

#include "haptics/contact/contact_step.h"

#include <algorithm>
#include <cmath>

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

// The time a step may still need to return once it is late. The first step on a scene needs more,
// because it finds neither data nor code in any cache.
constexpr std::int64_t return_ns = 3000;
constexpr std::int64_t cold_return_ns = 6500;

constexpr double octave_s = 0.05;         // a change of level that is hindered takes so long
constexpr double largest_push_N = 0.015;  // of a moving wall in a tick
constexpr double end_zone_m = 3e-3;       // where a proxy is that just slid off a line's end

/// Beyond the coarsest level nothing changes any more.
double bounded(const Scene& scene, double level) {
    if (!(level > 0.0)) return 0.0;
    return std::min(level, static_cast<double>(scene.curves.coarsest()));
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

void ContactMachine::reset(const Scene& scene, Position handle, double level) {
    outlines_ = RenderedOutlines(scene, bounded(scene, level));
    gap_ = {};
    force_ = {};
    is_gap_ = false;
    start_free(handle);
}

void ContactMachine::move_to(const Scene& scene) {
    outlines_ = RenderedOutlines(scene, bounded(scene, outlines_.level()));
    const Position handle = handle_;
    start_free(proxy_.centre);
    handle_ = handle;
}

void ContactMachine::start_free(Position handle) {
    proxy_ = {};
    proxy_.centre = handle;
    handle_ = handle;
    radius_m_ = 0.0;
    account_ = {};
    pace_octaves_ = largest_octaves;
    touched_piece_ = -1;
    groove_ = {};
    pop_through_ = {};
    is_fresh_ = true;
    const Scene& scene = outlines_.scene();
    // A handle nearer to a line than the skin goes onto its left. A second line as near is met in
    // the next round.
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
    if (settings.mode != mode_) take_mode(handle, settings.mode);
    Budget left = budget;
    if (left.deadline_ns != 0) left.deadline_ns -= is_fresh_ ? cold_return_ns : return_ns;
    is_fresh_ = false;
    const double wanted = bounded(outlines_.scene(), level);
    if (mode_ == Mode::wall) {
        press(handle, wanted, settings, left, dt_s, report);
    } else {
        hold(handle, wanted, settings, left, dt_s, report);
    }
    if (is_gap_ || gap_.is_open()) join(report, dt_s);
    force_ = report.force;
    fill(report);
    return report;
}

/// Wall mode: the wall may give way or move to another level; then the proxy follows the handle.
void ContactMachine::press(Position handle, double level, const ContactSettings& settings,
                           const Budget& budget, double dt_s, ContactReport& report) {
    Budget left = budget;
    const auto spend = [&](int boxes) {
        report.boxes += boxes;
        left.boxes -= boxes;
    };
    if (settings.pop_through_N > 0.0) {
        int boxes = 0;
        report.has_popped =
            pop_through_.step(outlines_, handle, settings, left, dt_s, proxy_, boxes);
        spend(boxes);
        is_gap_ = is_gap_ || report.has_popped;
        if (report.has_popped) radius_m_ = 0.0;
    }
    if (settings.radius_m != radius_m_) spend(widen(settings.radius_m, left));
    if (level != outlines_.level()) spend(change_level(level, handle, settings, left, dt_s));
    const Position start = handle - proxy_.centre;
    ContactStep(outlines_, settings, radius_m_, left, proxy_, path_).run(handle, report);
    book(handle, start, settings.stiffness_N_per_m, dt_s);
    const Position stretch = proxy_.centre - handle;
    report.force = along<Force>(stretch, settings.stiffness_N_per_m);
    report.stored_J = 0.5 * settings.stiffness_N_per_m * dot(stretch, stretch);
}

/// Refuses a proxy whose contacts do not lie in the scene.
bool ContactMachine::rebind(const Scene* scene) {
    constexpr double most_level = 64.0;
    path_ = nullptr;
    const double level = outlines_.level();
    if (scene == nullptr) outlines_ = {};
    if (scene == nullptr) return true;
    if (!(level >= 0.0 && level <= most_level)) return false;
    outlines_ = RenderedOutlines(*scene, level);
    const auto pieces = scene->curves.piece_count();
    if (touched_piece_ < -1 || touched_piece_ >= pieces || !groove_.fits(outlines_)) return false;
    if (proxy_.left.piece >= 0 && !outlines_.has(proxy_.left)) return false;
    const int least = proxy_.state == ContactState::free ? 0 : 1;
    if (proxy_.contact_count < least || proxy_.contact_count > 2) return false;
    for (int i = 0; i < proxy_.contact_count; ++i) {
        const Contact& contact = proxy_.contacts[static_cast<std::size_t>(i)];
        if (!outlines_.has(contact.segment)) return false;
    }
    return true;
}

int ContactMachine::widen(double wanted_m, const Budget& budget) {
    proxy_.spare_m = 0.0;
    if (wanted_m > radius_m_ && proxy_.state != ContactState::free) return 0;
    const Closest at = outlines_.scene().tree.closest_point(outlines_.scene().curves, proxy_.centre,
                                                            outlines_.level(), wanted_m, budget);
    if (wanted_m > radius_m_ && !at.is_complete) return at.boxes;
    radius_m_ = at.segment.piece < 0 ? wanted_m : std::min(wanted_m, at.distance_m);
    return at.boxes;
}

/// A machine that has not felt anything yet has nothing to fade from.
void ContactMachine::take_mode(Position handle, Mode mode) {
    is_gap_ = !is_fresh_;
    start_free(handle);
    mode_ = mode;
}

/// If the machine itself has changed the force, continues from what it was.
void ContactMachine::join(ContactReport& report, double dt_s) {
    if (is_gap_) gap_.start(force_, report.force);
    is_gap_ = false;
    report.force += gap_.step(dt_s);
}

/// Books what the proxy's move took from the spring, less what a sampled spring may give back at
/// the hand's next move.
void ContactMachine::book(Position handle, Position start, double stiffness_N_per_m, double dt_s) {
    const Position rest = handle - proxy_.centre;
    const Position moved = handle - handle_;
    handle_ = handle;
    const double square_m2 = dot(start, start) - dot(rest, rest) - dot(moved, moved);
    account_.earn(0.5 * stiffness_N_per_m * square_m2, dt_s);
}

/// Groove, ridge and stay: the proxy is the attachment.
void ContactMachine::hold(Position handle, double level, const ContactSettings& settings,
                          const Budget& budget, double dt_s, ContactReport& report) {
    const GrooveForce held = groove_.step(outlines_, level, handle, settings, budget, dt_s);
    proxy_ = {};
    proxy_.centre = held.p_WA;
    report.force = held.force;
    report.stored_J = held.stored_J;
    report.boxes = held.boxes;
    report.clear = held.is_complete ? 1.0 : 0.0;
    if (held.at.exists()) {
        proxy_.state = ContactState::edge;
        proxy_.contact_count = 1;
        proxy_.contacts[0] = {held.at.segment, held.at.parameter, held.side, {}, 0.0, false};
    }
    report.transitions.add(proxy_.state);
}

int ContactMachine::change_level(double level, Position handle, const ContactSettings& settings,
                                 const Budget& budget, double dt_s) {
    int boxes = 0;
    bool is_at_once = false;
    if (proxy_.state == ContactState::free) {
        const double radius = std::max(radius_m_, contact_skin_m);
        const Scene& scene = outlines_.scene();
        const Clearance found = scene.tree.clearance(scene.curves, proxy_.centre, radius,
                                                     std::max(level, outlines_.level()), budget);
        boxes = found.boxes;
        is_at_once = found.is_clear;
    }
    if (!is_at_once) {
        Budget left = budget;
        left.boxes -= boxes;
        return boxes + move_wall(level, handle, settings, left, dt_s);
    }
    outlines_ = RenderedOutlines(outlines_.scene(), level);
    proxy_.spare_m = 0.0;
    proxy_.left = {};
    return boxes;
}

/// Moves towards `level`, not past a whole level, with one try a tick. It goes as far as pushes the
/// hand by no more than a touch of force, as the tick before has found; after a try that found no
/// place, only a little way.
int ContactMachine::move_wall(double level, Position handle, const ContactSettings& settings,
                              const Budget& budget, double dt_s) {
    const double from = outlines_.level();
    const double goal = within_octave(from, level);
    const bool is_whole_way = pace_octaves_ >= std::abs(goal - from);
    const double to = is_whole_way ? goal : from + std::copysign(pace_octaves_, goal - from);
    MovingWall motion(outlines_, to, radius_m_, budget);
    const auto carried = motion.carry(
        proxy_, handle, {settings.stiffness_N_per_m, largest_push_N, account_.balance_J()});
    if (!carried) {
        pace_octaves_ = std::min(dt_s / octave_s, largest_octaves);
        return motion.boxes();
    }
    if (carried->push_N <= largest_push_N) {
        if (carried->is_allowed && account_.spend(carried->work_J)) {
            proxy_ = carried->proxy;
            outlines_ = motion.after();
        }
        pace_octaves_ = std::min(2.0 * pace_octaves_, largest_octaves);
    } else {
        pace_octaves_ = 0.95 * std::abs(to - from) * largest_push_N / carried->push_N;
    }
    return motion.boxes();
}

void ContactMachine::fill(ContactReport& report) {
    report.p_WP = proxy_.centre;
    report.state = proxy_.state;
    report.level = outlines_.level();
    if (proxy_.state == ContactState::free) {
        if (touched_piece_ >= 0) report.is_at_end = is_beyond_end(touched_piece_);
        touched_piece_ = -1;
        return;
    }
    const Contact& at = proxy_.contacts[0];
    const CurveSet& curves = outlines_.scene().curves;
    const Piece& piece = curves.piece(at.segment.piece);
    report.level = curves.rendered_level(at.segment.piece, outlines_.level());
    report.outline = piece.outline;
    report.piece = touched_piece_ = at.segment.piece;
    report.parameter = curves.outline_parameter(at.segment.piece, outlines_.level(),
                                                at.segment.index, at.parameter);
    report.side = at.side;
    const bool is_at_vertex = at.parameter == 0.0 || at.parameter == 1.0;
    report.is_at_end = is_at_vertex && outlines_.next(at.segment, at.parameter > 0.5).piece < 0;
}

/// Returns true if a proxy that is free again slid off the end of an open line: it is beside the
/// end, further on.
bool ContactMachine::is_beyond_end(int piece) {
    const CurveSet& curves = outlines_.scene().curves;
    const Piece& line = curves.piece(piece);
    const int last = curves.rendered_count(piece, outlines_.level()) - 1;
    const auto is_beyond = [&](Position end, Position inward) {
        const Position off = proxy_.centre - end;
        return norm(off) < end_zone_m && dot(off, inward) <= 0.0;
    };
    const Segment first = outlines_.segment({piece, 0});
    if (line.previous < 0 && !line.is_closed && is_beyond(first.a, first.b - first.a)) return true;
    const Segment s = outlines_.segment({piece, last});
    return line.next < 0 && !line.is_closed && is_beyond(s.b, s.a - s.b);
}

}  // namespace touchline
