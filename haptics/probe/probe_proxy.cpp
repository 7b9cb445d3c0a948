#include "haptics/probe/probe_proxy.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

// How near a shape comes to lines.

/// A shape without radius stays this far from every line, so that rounding never changes a side.
constexpr double probe_gap_m = 5e-8;

/// How much nearer than that a touching edge may come while it turns: second order of a step.
constexpr double probe_slack_m = 3e-8;

/// How much nearer a line may be that the shape passes; otherwise every vertex of a straight line
/// would stop it.
constexpr double probe_graze_m = 5e-10;

/// A line this much further than the kept distance still touches.
constexpr double probe_touch_m = 1e-9;

/// A line this much further than the kept distance already counts; otherwise two contacts would
/// take turns.
constexpr double probe_mind_m = 1e-7;

/// Returns how near an edge at `distance_m` may come if it should stay `keep_m` off.
double least_distance_m(double keep_m, double distance_m) {
    return keep_m - (distance_m > keep_m + probe_mind_m ? probe_graze_m : probe_slack_m);
}

constexpr double least_lever_m = 5e-3;
constexpr double rest_m = 1e-10;          // a shorter move counts as none
constexpr int most_moves = 16;            // in a step
constexpr std::size_t most_swept = 1024;  // pairs in a step; the rest is carried
constexpr int most_bends = 3;             // corrections of a move for curving distances
// A chord cuts off a quarter of the bend between its ends.
constexpr double most_bend_m = 3.0 * probe_slack_m;

ContactState state_of(int contacts) {
    if (contacts == 0) return ContactState::free;
    return contacts == 1 ? ContactState::edge : ContactState::vertex;
}

/// Returns twice the energy that a move leaves, divided by the stiffness.
double left_of_move(const Coupled& wanted, const Coupled& move) {
    return square({wanted[0] - move[0], wanted[1] - move[1], wanted[2] - move[2]});
}

constexpr double largest_jump_N = 0.015;  // change of the force in a tick by a change of level
constexpr int most_halvings = 4;

/// Returns how far an edge is from a line along a direction, which is at most their distance.
double room_along(Direction normal, const Segment& edge, const Segment& line) {
    return std::min(dot(normal, edge.a), dot(normal, edge.b)) -
           std::max(dot(normal, line.a), dot(normal, line.b));
}

}  // namespace

double turn_stiffness_Nm_per_rad(const ProbeShape& shape, double stiffness_N_per_m) {
    const double lever_m = std::max(shape.r_max_m(), least_lever_m);
    return stiffness_N_per_m * lever_m * lever_m;
}

double ProbeProxy::Springs::energy_J(const ProbeMove& to) const {
    const double turn_m = lever_m * to.turn_rad;
    return 0.5 * k_N_per_m * (dot(to.by, to.by) + turn_m * turn_m);
}

ProbeProxy::Springs ProbeProxy::springs(const ProbeSettings& settings) const {
    const double k = settings.stiffness_N_per_m;
    const double k_r = settings.turn_stiffness_Nm_per_rad > 0.0
                           ? settings.turn_stiffness_Nm_per_rad
                           : turn_stiffness_Nm_per_rad(*shape_, k);
    return {k, std::sqrt(k_r / k)};
}

void ProbeProxy::reserve() {
    front_.reserve();
    wide_.reserve();
    constraints_.reserve(most_constraints);
    touching_.reserve(most_constraints);
    seen_.reserve(most_constraints);
    pairs_.reserve(most_constraints);
}

void ProbeProxy::reset(const ProbeShape& shape, const Scene& scene, const ProbePose& handle,
                       double level) {
    shape_ = &shape;
    keep_m_ = std::max(shape.radius_m(), probe_gap_m);
    pose_ = handle;
    front_.reset(shape, scene, level);
    wide_.reset(shape, scene, level, FrontEnd::nodes);
    reserve();
    account_ = {};
    state_ = ContactState::free;
    last_reach_m_ = 0.0;
    is_placed_ = false;
}

ProbeReport ProbeProxy::step(const ProbePose& handle, double level, const ProbeSettings& settings,
                             const Budget& budget, double dt_s) {
    ProbeReport report;
    report.transitions = StateTrail(state_);
    if (path_ != nullptr) path_->assign(1, pose_);
    if (is_finite(handle)) {
        Spender spender(budget);
        const Springs coupling = springs(settings);
        if (!is_placed_) {
            if (level != front_.level()) front_.set_level(level);
            place(handle, spender);
        }
        if (is_placed_) {
            if (level != front_.level()) change_level(level, handle, coupling, spender);
            const double before_J = coupling.energy_J(handle - pose_);
            press(handle, coupling, spender, report);
            const ProbeMove left = pose_ - handle;
            report.stored_J = coupling.energy_J(left);
            account_.earn(before_J - report.stored_J, dt_s);
            report.force = along<Force>(left.by, coupling.k_N_per_m);
            report.torque_Nm =
                coupling.k_N_per_m * coupling.lever_m * coupling.lever_m * left.turn_rad;
        }
        report.boxes = spender.opened();
    }
    state_ = state_of(report.contact_count);
    report.transitions.add(state_);
    report.state = state_;
    report.pose = pose_;
    report.is_placed = is_placed_;
    report.level = front_.level();
    return report;
}

/// The proxy jumps to the handle, and is placed there for good if nothing is near.
void ProbeProxy::place(const ProbePose& handle, Spender& spender) {
    front_.spend((handle - pose_).reach_m(shape_->r_max_m()));
    pose_ = handle;
    front_.look(ProbePlacement(pose_), keep_m_, probe_touch_m, spender);
    is_placed_ = front_.near().empty() && std::isinf(front_.unopened_m());
    if (path_ != nullptr) path_->assign(1, pose_);
}

void ProbeProxy::press(const ProbePose& handle, const Springs& springs, Spender& spender,
                       ProbeReport& report) {
    double look_m = std::max(last_reach_m_, probe_mind_m);
    LeastMove held;
    Following following;
    std::size_t swept = 0;
    for (int i = 0; i < most_moves; ++i) {
        front_.look(ProbePlacement(pose_), keep_m_, look_m, spender);
        held = wanted_move(handle, springs, following);
        const ProbeMove move = move_of(held.move, springs);
        const double reach_m = move.reach_m(shape_->r_max_m());
        report.carried_m = 0.0;
        if (reach_m < rest_m) break;

        if (reach_m + probe_mind_m > look_m) {
            front_.look(ProbePlacement(pose_), keep_m_, reach_m + probe_mind_m, spender);
        }
        const double share = advance(move, report);
        swept += front_.near().size();
        if (i == 0) last_reach_m_ = share * reach_m;
        report.carried_m = reach_m;
        look_m = reach_m + 2.0 * probe_mind_m;  // the next is about as long
        if (swept > most_swept) break;
        if (share * reach_m >= rest_m) {
            following = {};
        } else if (!follow_otherwise(following)) {
            break;
        }
    }
    hold(held, springs, report);
}

/// Chooses what follows a move that was none. If another line cuts a curve short, the curve does
/// not end where its bend puts it, so it is found again, as short as was free. A curve that ends
/// under the move is followed straight.
bool ProbeProxy::follow_otherwise(Following& following) const {
    if (!following.is_curved) return false;
    const bool is_cut_short = free_m_ >= rest_m && following.longest_m == longest_move_m;
    following = is_cut_short ? Following{true, free_m_} : Following{false, longest_move_m};
    return true;
}

ProbeMove ProbeProxy::move_of(const Coupled& move, const Springs& springs) {
    return {{move[0], move[1]}, move[2] / springs.lever_m};
}

void ProbeProxy::find_touching(const Springs& springs) {
    constraints_.clear();
    touching_.clear();
    pairs_.clear();
    sunk_m_ = 0.0;
    const ProbePlacement placed(pose_);
    for (const NearPair& pair : front_.near()) {
        const EdgeAndLine& g = pair.geometry;
        const double gap_m = g.at.distance_m - keep_m_;
        if (gap_m > probe_mind_m || constraints_.size() == most_constraints) continue;
        touching_.emplace_back(placed(g.edge), g.line, g.at, pose_.place(), springs.lever_m);
        constraints_.push_back({touching_.back().row(), gap_m});
        pairs_.push_back(pair);
    }
}

/// Returns the move of least energy that the touching lines allow, no longer than is looked at
/// once. Its energy is no more than that of staying.
LeastMove ProbeProxy::wanted_move(const ProbePose& handle, const Springs& springs,
                                  const Following& following) {
    find_touching(springs);
    const ProbeMove left = handle - pose_;
    const Coupled wanted{left.by.x, left.by.y, springs.lever_m * left.turn_rad};
    LeastMove least = least_move(constraints_, wanted);
    if (!(left_of_move(wanted, least.move) <= square(wanted))) {
        // Making room again would cost energy, so all lines are taken to be that much further off.
        for (const Constraint& c : constraints_) sunk_m_ = std::max(sunk_m_, -c.gap_m);
        for (Constraint& c : constraints_) c.gap_m += sunk_m_;
        least = least_move(constraints_, wanted);
    }
    const auto is_worth = [&wanted](const Coupled& move) {
        return left_of_move(wanted, move) <= square(wanted);
    };
    const CurvedEnergy energy(touching_, least);
    const Coupled whole = energy.least(constraints_, wanted, seen_);
    for (const double share :
         {shortening(whole, springs, following.longest_m), gentleness(whole)}) {
        if (least.active_count == 0 || !following.is_curved) break;
        const Coupled curved = curved_move(energy, share * wanted, share * whole);
        if (!is_worth(curved)) continue;
        least.move = curved;
        return least;
    }
    least.move = shortening(least.move, springs, following.longest_m) * least.move;
    if (!is_worth(least.move)) least.move = {};
    return least;
}

/// Returns the share of a move that is looked at once.
double ProbeProxy::shortening(const Coupled& move, const Springs& springs, double longest_m) const {
    const double reach_m = move_of(move, springs).reach_m(shape_->r_max_m());
    return reach_m > longest_m ? longest_m / reach_m : 1.0;
}

/// Returns the share of a move over which no distance bends by more than the straight way may cut
/// off.
double ProbeProxy::gentleness(const Coupled& move) const {
    double most_m = most_bend_m;
    for (const Touching& touching : touching_) most_m = std::max(most_m, touching.bend_m(move));
    return std::sqrt(most_bend_m / most_m);
}

/// Returns the least move along distances that curve: finds their bend under the move, then the
/// move again.
Coupled ProbeProxy::curved_move(const CurvedEnergy& energy, const Coupled& wanted, Coupled move) {
    for (int round = 0; round < most_bends; ++round) {
        for (std::size_t i = 0; i < constraints_.size(); ++i) {
            const double gap_m = pairs_[i].geometry.at.distance_m - keep_m_ + sunk_m_;
            constraints_[i].gap_m = gap_m + std::min(touching_[i].bend_m(move), most_bend_m);
        }
        const Coupled before = move;
        move = energy.least(constraints_, wanted, seen_);
        if (left_of_move(before, move) < rest_m * rest_m) break;
    }
    return move;
}

/// Returns how much of the move is free of everything the last look found. A touching line may come
/// nearer on the way, by the slack, but not at its end.
double ProbeProxy::clear_share_of(const ProbeMove& move) {
    const double reach_m = move.reach_m(shape_->r_max_m());
    double share = 1.0;
    if (front_.unopened_m() < reach_m) share = std::max(front_.unopened_m(), 0.0) / reach_m;
    const ProbePlacement start(pose_);
    for (const NearPair& pair : front_.near()) {
        const double least_m = least_distance_m(keep_m_, pair.geometry.at.distance_m);
        if (pair.geometry.at.distance_m - least_m >= share * reach_m) continue;
        share = clear_share(pair.geometry, pose_, start, move, least_m, share);
    }
    free_m_ = share * reach_m;
    const ProbePlacement end(pose_ + share * move);
    for (const NearPair& pair : front_.near()) {
        const double start_m = pair.geometry.at.distance_m;
        if (start_m > keep_m_ + probe_mind_m) continue;
        const double least_m = std::min(start_m, keep_m_ - probe_graze_m);
        if (separation(end(pair.geometry.edge), pair.geometry.line).distance_m >= least_m - 1e-15) {
            continue;
        }
        for (const NearPair& strict : front_.near()) {
            const double strict_m =
                std::min(strict.geometry.at.distance_m, keep_m_ - probe_graze_m);
            share = clear_share(strict.geometry, pose_, start, move, strict_m, share);
        }
        break;
    }
    return share;
}

/// Moves until something is in the way. Returns the share of the move.
double ProbeProxy::advance(const ProbeMove& move, ProbeReport& report) {
    const double reach_m = move.reach_m(shape_->r_max_m());
    if (front_.unopened_m() < reach_m) {
        report.clear = std::min(report.clear, std::max(front_.unopened_m(), 0.0) / reach_m);
    }
    const double share = clear_share_of(move);
    pose_ = pose_ + share * move;
    front_.spend(share * reach_m);
    if (path_ != nullptr) path_->push_back(pose_);
    return share;
}

void ProbeProxy::hold(const LeastMove& held, const Springs& springs, ProbeReport& report) {
    for (int i = 0; i < held.active_count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double force_N = springs.k_N_per_m * held.push_m[k];
        if (!(force_N > 0.0)) continue;
        ProbeContact& contact = report.contacts[static_cast<std::size_t>(report.contact_count++)];
        contact = contact_at(pairs_[static_cast<std::size_t>(held.active[k])]);
        contact.force_N = force_N;
    }
}

ProbeContact ProbeProxy::contact_at(const NearPair& pair) {
    const Separation& at = pair.geometry.at;
    const Segment& line = pair.geometry.line;
    ProbeContact contact;
    contact.segment = front_.segment_of(pair);
    contact.parameter = foot(at.on_second, front_.outlines().segment(contact.segment)).parameter;
    contact.side = cross(line.b - line.a, at.normal) >= 0.0 ? Side::left : Side::right;
    contact.place = at.on_first;
    contact.normal = at.normal;
    return contact;
}

/// Changes the rendered level under the shape, as a motion of the lines.
void ProbeProxy::change_level(double level, const ProbePose& handle, const Springs& springs,
                              Spender& spender) {
    const double from = front_.level();
    double next =
        std::clamp(within_octave(from, level), from - largest_octaves, from + largest_octaves);
    for (int i = 0; i <= most_halvings; ++i) {
        if (try_level(next, handle, springs, spender)) return;
        next = 0.5 * (from + next);
    }
}

/// Within an octave every point of a line moves straight. So two lines that lie apart along a
/// direction before and after lie apart all the time.
ProbeProxy::Room ProbeProxy::room_at(double level, const Springs& springs, Spender& spender) {
    const double from = front_.level();
    const int finer = static_cast<int>(std::floor(std::min(from, level)));
    const CurveSet& curves = front_.outlines().scene().curves;
    const double jump_m = largest_jump_N / springs.k_N_per_m;
    const ProbePlacement placed(pose_);
    Room room{true, true};
    constraints_.clear();
    wide_.look(placed, keep_m_, probe_touch_m, spender);
    if (!std::isinf(wide_.unopened_m())) return {false, false};
    for (const NearPair& pair : wide_.near()) {
        if (pair.node.level != finer + 1) continue;  // a piece without that octave
        const RenderedPiece before = curves.blend(pair.node.piece, finer, from - finer);
        const RenderedPiece after = curves.blend(pair.node.piece, finer, level - finer);
        const Segment edge = placed(pair.geometry.edge);
        for (int j = 2 * pair.node.index; j <= 2 * pair.node.index + 1; ++j) {
            if (j >= before.segment_count()) continue;
            const Separation at = separation(edge, before.segment(j));
            const double room_m = room_along(at.normal, edge, after.segment(j));
            const bool touches = at.distance_m <= keep_m_ + probe_touch_m;
            if (room_m < least_distance_m(keep_m_, at.distance_m)) room.is_free = false;
            if (touches && std::abs(room_m - at.distance_m) > jump_m) room.is_possible = false;
            if (!touches && !(room_m >= least_distance_m(keep_m_, at.distance_m) - jump_m)) {
                room.is_possible = false;
            }
            if (room_m > keep_m_ + probe_touch_m) continue;
            if (constraints_.size() == constraints_.capacity()) return {false, false};
            const Touching touching(edge, before.segment(j), at, pose_.place(), springs.lever_m);
            constraints_.push_back({touching.row(), room_m - keep_m_});
        }
    }
    return room;
}

bool ProbeProxy::try_level(double level, const ProbePose& handle, const Springs& springs,
                           Spender& spender) {
    wide_.set_level(std::floor(std::min(front_.level(), level)) + 0.5);
    Room room = room_at(level, springs, spender);
    if (!room.is_possible) return false;
    if (!room.is_free) {
        // The shape goes first; the lines follow.
        const LeastMove least = least_move(constraints_, {});
        const ProbeMove move = move_of(least.move, springs);
        const double reach_m = move.reach_m(shape_->r_max_m());
        const ProbePose start = pose_;
        const double work_J =
            springs.energy_J(handle - (pose_ + move)) - springs.energy_J(handle - pose_);
        if (!(springs.k_N_per_m * std::sqrt(square(least.move)) <= largest_jump_N)) return false;
        if (!(work_J <= account_.balance_J())) return false;
        front_.look(ProbePlacement(pose_), keep_m_, reach_m + probe_touch_m, spender);
        if (clear_share_of(move) < 1.0) return false;
        pose_ = start + move;
        front_.spend(reach_m);
        wide_.spend(reach_m);
        room = room_at(level, springs, spender);
        if (!room.is_free) {
            pose_ = start;
            front_.spend(reach_m);
            return false;
        }
        if (path_ != nullptr) path_->push_back(pose_);
        (void)account_.spend(work_J);
    }
    front_.set_level(level);
    return true;
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
