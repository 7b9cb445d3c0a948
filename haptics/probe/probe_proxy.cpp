#include "haptics/probe/probe_proxy.h"

#include "haptics/probe/kept_distance.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

constexpr double least_lever_m = 5e-3;
constexpr double first_look_m = 3e-5;  // along a move
constexpr int most_moves = 16;         // in a step
constexpr int most_long_moves = 8;
constexpr std::size_t little_swept = 48;  // pairs in a step that may take all its moves
constexpr std::size_t most_swept = 1024;  // pairs in a step; the rest is carried

ContactState state_of(int contacts) {
    if (contacts == 0) return ContactState::free;
    return contacts == 1 ? ContactState::edge : ContactState::vertex;
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
    put(handle);
    front_.reset(shape, scene, level);
    wide_.reset(shape, scene, level, FrontEnd::nodes);
    reserve();
    account_ = {};
    state_ = ContactState::free;
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

void ProbeProxy::put(const ProbePose& pose) {
    pose_ = pose;
    placed_ = ProbePlacement(pose);
}

/// The proxy jumps to the handle, and is placed there for good if nothing is near.
void ProbeProxy::place(const ProbePose& handle, Spender& spender) {
    front_.spend((handle - pose_).reach_m(shape_->r_max_m()));
    put(handle);
    front_.look(placed_, keep_m_, probe_touch_m, spender);
    is_placed_ = front_.near().empty() && std::isinf(front_.unopened_m());
    if (path_ != nullptr) path_->assign(1, pose_);
}

void ProbeProxy::press(const ProbePose& handle, const Springs& springs, Spender& spender,
                       ProbeReport& report) {
    LeastMove held;
    Following following;
    std::size_t swept = 0;
    for (int i = 0; i < most_moves; ++i) {
        if (i == 0) {
            front_.look(placed_, keep_m_, probe_mind_m, spender);
        } else {
            front_.look_again(placed_);
        }
        const ProbeMove move = wanted_move(handle, springs, following, held);
        const double reach_m = move.reach_m(shape_->r_max_m());
        report.carried_m = 0.0;
        if (!(reach_m >= probe_rest_m)) break;

        const bool can_shorten = following.is_curved && following.longest_m == longest_move_m;
        const double share = advance(move, handle, springs, spender, can_shorten, report);
        swept += front_.near().size();
        report.carried_m = reach_m;
        const bool is_long = i + 1 >= most_long_moves && swept > little_swept;
        if (is_long || swept > most_swept) break;
        if (share * reach_m >= std::max(probe_rest_m, 0.5 * free_m_)) {
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
    const bool is_cut_short = free_m_ >= probe_rest_m && following.longest_m == longest_move_m;
    following = is_cut_short ? Following{true, free_m_} : Following{false, longest_move_m};
    return true;
}

ProbeMove ProbeProxy::move_of(const Coupled& move, const Springs& springs) {
    return {{move[0], move[1]}, move[2] / springs.lever_m, {}};
}

void ProbeProxy::find_touching(const Springs& springs) {
    constraints_.clear();
    touching_.clear();
    pairs_.clear();
    sunk_m_ = 0.0;
    for (const NearPair& pair : front_.near()) {
        const EdgeAndLine& g = pair.geometry;
        const double gap_m = g.at.distance_m - keep_m_;
        if (gap_m > probe_mind_m || constraints_.size() == most_constraints) continue;
        touching_.emplace_back(placed_(g.edge), g.line, g.at, pose_.place(), springs.lever_m);
        constraints_.push_back({touching_.back().row(), gap_m});
        pairs_.push_back(pair);
    }
}

/// Returns the move of least energy that the touching lines allow, no longer than is looked at
/// once. Its energy is no more than that of staying.
ProbeMove ProbeProxy::wanted_move(const ProbePose& handle, const Springs& springs,
                                  const Following& following, LeastMove& least) {
    find_touching(springs);
    const ProbeMove left = handle - pose_;
    const Coupled wanted{left.by.x, left.by.y, springs.lever_m * left.turn_rad};
    const auto is_worth = [&wanted](const Coupled& move) {
        return left_of_move(wanted, move) <= square(wanted);
    };
    least = least_move(constraints_, wanted);
    if (!is_worth(least.move)) {
        // Making room again would cost energy, so all lines are taken to be that much further off.
        for (const Constraint& c : constraints_) sunk_m_ = std::max(sunk_m_, -c.gap_m);
        for (Constraint& c : constraints_) c.gap_m += sunk_m_;
        least = least_move(constraints_, wanted);
    }
    if (least.active_count > 0 && following.is_curved) {
        ProbeMove move;
        if (curved_move(wanted, springs, following, least, move)) return move;
    }
    least.move = shortening(least.move, springs, following.longest_m) * least.move;
    if (!is_worth(least.move)) least.move = {};
    return move_of(least.move, springs);
}

/// Returns how much of the move is free of everything but what touches and comes nearer on the way
/// by the slack. Where nothing touches yet the move mostly ends early: it is looked along in parts.
double ProbeProxy::free_share_of(const ProbeMove& move, Spender& spender) {
    const double reach_m = move.reach_m(shape_->r_max_m());
    const double first_m = constraints_.empty() ? first_look_m : reach_m;
    double part = first_m < reach_m ? first_m / reach_m : 1.0;
    for (;; part = std::min(4.0 * part, 1.0)) {
        front_.look_along(part * move, placed_, keep_m_, spender);
        double share = part;
        if (front_.unopened_m() < part * reach_m) {
            share = std::max(front_.unopened_m(), 0.0) / reach_m;
        }
        for (const NearPair& pair : front_.near()) {
            const double least_m = least_distance_m(keep_m_, pair.geometry.at.distance_m);
            if (pair.geometry.at.distance_m - least_m >= share * reach_m) continue;
            share = clear_share(pair.geometry, placed_, move, least_m, share);
        }
        if (!(share >= part) || part == 1.0) return share;
    }
}

/// Returns how much of the move is free of everything. A touching line may come nearer on the way,
/// by the slack, but not at its end.
double ProbeProxy::clear_share_of(const ProbeMove& move, Spender& spender, bool can_shorten) {
    const double reach_m = move.reach_m(shape_->r_max_m());
    double share = free_share_of(move, spender);
    free_m_ = share * reach_m;
    const ProbePlacement end = placed_.after(share * move);
    for (const NearPair& pair : front_.near()) {
        const double start_m = pair.geometry.at.distance_m;
        if (start_m > keep_m_ + probe_mind_m) continue;
        const double least_m = std::min(start_m, keep_m_ - probe_graze_m);
        if (separation(end(pair.geometry.edge), pair.geometry.line).distance_m >= least_m - 1e-15) {
            continue;
        }
        if (can_shorten && share < 1.0) return 0.0;
        for (const NearPair& strict : front_.near()) {
            const double strict_m =
                std::min(strict.geometry.at.distance_m, keep_m_ - probe_graze_m);
            share = clear_share(strict.geometry, placed_, move, strict_m, share);
        }
        break;
    }
    return share;
}

/// Moves until something is in the way. Returns the share of the move; 0 if it would end with more
/// energy, as a roll that is cut short may.
double ProbeProxy::advance(const ProbeMove& move, const ProbePose& handle, const Springs& springs,
                           Spender& spender, bool can_shorten, ProbeReport& report) {
    const double reach_m = move.reach_m(shape_->r_max_m());
    const double share = clear_share_of(move, spender, can_shorten);
    if (front_.unopened_m() < reach_m) {
        report.clear = std::min(report.clear, std::max(front_.unopened_m(), 0.0) / reach_m);
    }
    if (!(share > 0.0)) return 0.0;
    const ProbePose to = pose_ + share * move;
    if (!(springs.energy_J(handle - to) <= springs.energy_J(handle - pose_))) return 0.0;
    if (path_ != nullptr) add_way(pose_, share * move, *path_);
    put(to);
    front_.spend(share * reach_m);
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
