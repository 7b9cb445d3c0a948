#include "tests/lab/bench/tracing/follower.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace touchline::bench {
namespace {

constexpr double sweep_m_per_s = 0.2;
constexpr double follow_m_per_s = 0.05;
constexpr double probe_m_per_s = 0.05;
constexpr double settle_m_per_s = 0.03;
constexpr double leash_m = 0.002;     // the hand aims at most this far ahead of the handle
constexpr double yield_s = 0.02;      // to give way across its direction
constexpr double turn_per_Ns = 40.0;  // turns towards the force across its way
constexpr double line_N = 0.1;        // a greater force is a line's
constexpr double held_N = 0.12;       // against the way: the line does not go on here
constexpr double held_long_s = 0.02;
constexpr double still_N = 0.04;   // below this it is on the line
constexpr double probe_m = 0.002;  // radius
constexpr double branch_N = 0.17;  // at most, where a line crosses the circle
constexpr double known_reach_m = 0.0015;
constexpr double near_known_m = 0.0035;
constexpr double recent_m = 0.012;  // a line followed lately is nothing new
constexpr double known_enough_m = 0.005;
constexpr double same_place_m = 0.0015;
constexpr double all_m = 1e9;

Direction turned_by(Direction d, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * d.x - s * d.y, s * d.x + c * d.y};
}

double angle_of(Position p) {
    return std::atan2(p.y, p.x);
}

}  // namespace

GrooveFollower::GrooveFollower(const Area& area, Position start)
    : sweep_(area), meant_(start), last_(start) {}

Intention GrooveFollower::step(const Touched& touched, double dt_s) {
    meant_speed_ = {};
    switch (doing_) {
        case Doing::sweep:
            sweep(touched, dt_s);
            break;
        case Doing::settle:
            settle(touched, dt_s);
            break;
        case Doing::probe:
            probe(touched, dt_s);
            break;
        case Doing::follow:
            follow(touched, dt_s);
            break;
        case Doing::travel:
            travel(touched, dt_s);
            break;
        case Doing::done:
            break;
    }
    last_ = touched.handle;
    return {meant_, meant_speed_};
}

bool GrooveFollower::go_to(Position target, double speed_m_per_s, double dt_s) {
    const Position left = target - meant_;
    const double step_m = speed_m_per_s * dt_s;
    if (norm(left) <= step_m) {
        meant_ = target;
        return true;
    }
    meant_ += along<Position>(direction_of(left), step_m);
    meant_speed_ = along<Velocity>(direction_of(left), speed_m_per_s);
    return false;
}

void GrooveFollower::sweep(const Touched& touched, double dt_s) {
    const bool is_line = norm(touched.force) > line_N && sweep_.is_inside(touched.handle);
    if (is_line && !felt_.is_known(touched.handle, near_known_m, all_m)) return begin_settling();
    if (sweep_.is_over()) {
        doing_ = Doing::done;
        return;
    }
    if (go_to(sweep_.goal(), sweep_m_per_s, dt_s)) sweep_.arrive();
}

void GrooveFollower::begin_settling() {
    doing_ = Doing::settle;
    waited_s_ = 0.0;
}

/// Yields to the force until there is none.
void GrooveFollower::settle(const Touched& touched, double dt_s) {
    constexpr double longest_s = 0.4;
    constexpr double shortest_s = 0.06;
    waited_s_ += dt_s;
    if (norm(touched.force) > still_N) {
        meant_ = touched.handle + along<Position>(direction_of(touched.force), 0.001);
    } else {
        meant_ += std::min(1.0, dt_s / yield_s) * (touched.handle - meant_);
    }
    const bool is_still = norm(touched.force) < still_N && waited_s_ > shortest_s;
    if (is_still || waited_s_ > longest_s) begin_probe(touched.handle);
}

/// Probes at most twice in one place, because more would tell nothing new.
void GrooveFollower::begin_probe(Position around) {
    const auto here = std::count_if(probed_.begin(), probed_.end(),
                                    [&](Position p) { return norm(p - around) < same_place_m; });
    if (here >= 2) return take_next_branch();
    probed_.push_back(around);
    doing_ = Doing::probe;
    centre_ = around;
    samples_.clear();
    turned_ = 0.0;
    // Starts from behind, so that it feels what lies ahead in one sweep.
    turn_from_ = std::atan2(-ahead_.y, -ahead_.x);
}

void GrooveFollower::probe(const Touched& touched, double dt_s) {
    constexpr double whole = 2.5 * std::numbers::pi;  // a little over a turn
    turned_ += probe_m_per_s / probe_m * dt_s;
    const double angle = turn_from_ + turned_;
    const Direction out{std::cos(angle), std::sin(angle)};
    // Aims so far out that the handle, which the groove holds back, is on the circle.
    const Position at = touched.handle - centre_;
    const double short_m = probe_m - norm(at);
    meant_ = centre_ + along<Position>(out, probe_m + std::clamp(short_m, -0.001, 0.001));
    if (turned_ > 0.4 * std::numbers::pi) samples_.push_back({angle_of(at), touched.force});
    if (turned_ > whole) choose_branch();
}

/// A line leaves the circle where the force along it changes from onwards to backwards.
std::vector<Direction> GrooveFollower::branches() const {
    constexpr double apart = 0.35;
    constexpr std::size_t smooth = 8;
    std::vector<Direction> found;
    std::vector<double> onward;
    for (std::size_t i = 0; i + smooth < samples_.size(); ++i) {
        double sum = 0.0;
        for (std::size_t k = i; k < i + smooth; ++k) {
            const Direction out{std::cos(samples_[k].angle), std::sin(samples_[k].angle)};
            sum += dot(left_of(out), samples_[k].force);
        }
        onward.push_back(sum / smooth);
    }
    for (std::size_t i = 1; i < onward.size(); ++i) {
        if (!(onward[i - 1] > 0.0 && onward[i] <= 0.0)) continue;
        const Sample& at = samples_[i + smooth / 2];
        if (norm(at.force) > branch_N) continue;
        const Direction out{std::cos(at.angle), std::sin(at.angle)};
        const bool is_new = std::none_of(
            found.begin(), found.end(), [&](Direction d) { return dot(d, out) > std::cos(apart); });
        if (is_new) found.push_back(out);
    }
    return found;
}

bool GrooveFollower::is_worth(const Branch& branch) const {
    const auto is_known = [&](double ahead_m) {
        return felt_.is_known(branch.from + along<Position>(branch.along, ahead_m), 0.001, all_m);
    };
    return !is_known(probe_m) || !is_known(2.0 * probe_m);
}

void GrooveFollower::choose_branch() {
    const std::vector<Direction> found = branches();
    // Takes the straightest first; it knows the one that it came by.
    std::vector<Branch> good;
    for (const Direction d : found) {
        const Branch branch{centre_, d};
        if (is_worth(branch)) good.push_back(branch);
    }
    std::sort(good.begin(), good.end(), [&](const Branch& a, const Branch& b) {
        return dot(a.along, ahead_) < dot(b.along, ahead_);
    });
    felt_.add(centre_, followed_m_);
    left_.insert(left_.end(), good.begin(), good.end());
    take_next_branch();
}

void GrooveFollower::take_next_branch() {
    while (!left_.empty()) {
        const Branch branch = left_.back();
        left_.pop_back();
        if (!is_worth(branch)) continue;
        next_ = branch;
        probes_there_ = false;
        doing_ = Doing::travel;
        return;
    }
    doing_ = Doing::sweep;
}

void GrooveFollower::travel(const Touched& touched, double dt_s) {
    const bool is_there = go_to(next_->from, sweep_m_per_s, dt_s);
    const bool has_followed = norm(touched.handle - next_->from) < 0.0015;
    waited_s_ = is_there ? waited_s_ + dt_s : 0.0;
    if (!is_there || (!has_followed && waited_s_ < 0.3)) return;
    if (std::exchange(probes_there_, false)) return begin_settling();
    take(*next_);
}

/// Has lost the line, so goes back to where it last was.
void GrooveFollower::probe_again_at(Position around) {
    next_ = Branch{around, ahead_};
    probes_there_ = true;
    doing_ = Doing::travel;
    waited_s_ = 0.0;
}

void GrooveFollower::take(const Branch& branch) {
    doing_ = Doing::follow;
    ahead_ = branch.along;
    known_m_ = slack_m_ = held_s_ = 0.0;
    begun_m_ = followed_m_;
}

void GrooveFollower::follow(const Touched& touched, double dt_s) {
    const double way_m = std::max(0.0, dot(touched.handle - last_, ahead_));
    followed_m_ += way_m;
    const double across_N = dot(left_of(ahead_), touched.force);
    const double against_N = -dot(ahead_, touched.force);
    // Past a corner it is held back and turned at once; what turns it is its way.
    ahead_ = turned_by(ahead_, std::clamp(turn_per_Ns * across_N, -30.0, 30.0) * dt_s);

    Position lead = touched.handle - meant_;
    lead = -lead + along<Position>(ahead_, follow_m_per_s * dt_s);
    const double ahead_m = std::clamp(dot(lead, ahead_), -leash_m, leash_m);
    const double beside_m = dot(lead, left_of(ahead_)) * (1.0 - std::min(1.0, dt_s / yield_s));
    meant_ = touched.handle + along<Position>(ahead_, ahead_m) +
             along<Position>(left_of(ahead_), beside_m);
    meant_speed_ = along<Velocity>(ahead_, follow_m_per_s);

    const bool is_known = felt_.is_known(touched.handle, known_reach_m, begun_m_) ||
                          felt_.is_known(touched.handle, known_reach_m, followed_m_ - recent_m);
    known_m_ = is_known ? known_m_ + way_m : 0.0;
    felt_.add(touched.handle, followed_m_);
    // There is no line without any force at all.
    constexpr double no_line_m = 0.008;
    constexpr double no_line_N = 0.005;
    const bool is_felt = norm(touched.force) > no_line_N;
    slack_m_ = is_felt ? 0.0 : slack_m_ + way_m;
    if (is_felt) touched_ = touched.handle;
    if (slack_m_ > no_line_m) return probe_again_at(touched_);
    held_s_ = against_N > held_N ? held_s_ + dt_s : 0.0;
    const bool is_nearly_begun = followed_m_ - begun_m_ < known_enough_m;
    if (held_s_ > held_long_s) {
        begin_settling();
    } else if ((known_m_ > known_enough_m && !is_nearly_begun) ||
               !sweep_.is_inside(touched.handle)) {
        take_next_branch();
    }
}

}  // namespace touchline::bench
