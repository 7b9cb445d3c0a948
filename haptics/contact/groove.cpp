#include "haptics/contact/groove.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr int max_segments = 256;  // slid over in a tick

/// Where a slide along one segment ends.
struct Slide {
    Attachment at;
    double way_m = 0.0;
};

/// Goes on to the neighbour ahead (behind) if the foot there is nearer than the one here: to its
/// near end if this segment's end is reached, or, inside a bend, to the foot itself.
std::optional<Slide> onward(RenderedOutlines& outlines, const Attachment& at, const Foot& here,
                            Position handle, bool is_forward) {
    const SegmentRef next = outlines.next(at.segment, is_forward);
    if (next.piece < 0) return {};
    const Segment s = outlines.segment(next);
    const Foot there = foot(handle, s);
    if (!(there.distance_m < here.distance_m)) return {};
    const Position joint = is_forward ? s.a : s.b;
    const double near_end = is_forward ? 0.0 : 1.0;
    if (at.parameter == 1.0 - near_end) return Slide{{next, near_end}, 0.0};
    return Slide{{next, there.parameter}, norm(joint - here.point) + norm(there.point - joint)};
}

constexpr double handover_margin_m = 2e-4;
constexpr double fade_s = 0.03;                  // of a handover
constexpr double largest_fade_N = 0.015;         // in a tick
constexpr double recovery_s = 0.05;              // of the strength, 0 to 1
constexpr double valley_m = 1.5e-3;              // between two ridges, where both have a share
constexpr double largest_level_push_N = 0.0075;  // by a change of level in a tick
constexpr double largest_slide_N = 0.0075;       // by a slide that is late, in a tick
constexpr double largest_hop_N = 0.015;          // across the inside of a bend

double blend(double before, double now, double share) {
    return before + share * (now - before);
}

}  // namespace

Position point_of(RenderedOutlines& outlines, const Attachment& at) {
    return point_of(outlines.segment(at.segment), at.parameter);
}

Attachment slid(RenderedOutlines& outlines, Attachment at, Position handle, double longest_m,
                double longest_hop_m) {
    double left_m = longest_m;
    for (int i = 0; i < max_segments; ++i) {
        const Segment s = outlines.segment(at.segment);
        const Foot here = foot(handle, s);
        const double length_m = norm(s.b - s.a);
        const double way = here.parameter - at.parameter;
        if (!(std::abs(way) * length_m <= left_m)) {
            at.parameter += std::copysign(left_m / length_m, way);
            return at;
        }
        left_m -= std::abs(way) * length_m;
        at.parameter = here.parameter;
        auto next = onward(outlines, at, here, handle, true);
        if (!next) next = onward(outlines, at, here, handle, false);
        if (!next || !(next->way_m <= longest_hop_m)) return at;
        longest_hop_m -= next->way_m;
        at = next->at;
    }
    return at;
}

Attachment at_level(const CurveSet& curves, const Attachment& at, double from, double to) {
    const int piece = at.segment.piece;
    const double parameter = curves.outline_parameter(piece, from, at.segment.index, at.parameter);
    const double from_start = parameter - curves.piece(piece).first_parameter;
    const int stride = 1 << static_cast<int>(curves.rendered_level(piece, to));
    const int last = curves.rendered_count(piece, to) - 1;
    const int index = std::clamp(static_cast<int>(from_start / stride), 0, last);
    const double begin = curves.outline_parameter(piece, to, index, 0.0);
    const double end = curves.outline_parameter(piece, to, index, 1.0);
    return {{piece, index}, std::clamp((parameter - begin) / (end - begin), 0.0, 1.0)};
}

GrooveForce Groove::step(RenderedOutlines& outlines, double level, Position handle,
                         const ContactSettings& settings, const Budget& budget, double dt_s) {
    const CaptureLaw law(settings);
    const double stiffness_N_per_m = settings.stiffness_N_per_m;
    mode_ = settings.mode;
    const Position moved = is_fresh_ ? Position{} : handle - handle_;
    change_level(outlines, level, law);
    const double slide_m = 2.0 * norm(moved) + largest_slide_N / law.steepest_N_per_m();
    slide(outlines, handle, law, slide_m, slide_m + largest_hop_N / law.steepest_N_per_m());
    GrooveForce result;
    const double most_N = law.steepest_N_per_m() * norm(moved) + largest_fade_N;
    look_for_nearer(outlines, handle, law, budget, most_N, result);

    const Part now = part_of(outlines, now_, handle, law);
    const Part before = part_of(outlines, before_, handle, law);
    shift(now, before, dt_s);
    store(blend(before.energy_J, now.energy_J, share_), moved, stiffness_N_per_m, dt_s);
    force_ = strength_ * (before.force + share_ * (now.force - before.force));
    handle_ = handle;
    is_fresh_ = false;

    result.force = force_;
    result.stored_J = energy_J_;
    result.p_WA = handle;
    result.at = now_.exists() && (share_ >= 0.5 || !before_.exists()) ? now_ : before_;
    if (!result.at.exists()) return result;
    result.p_WA = point_of(outlines, result.at);
    const Segment s = outlines.segment(result.at.segment);
    result.side = cross(s.b - s.a, handle - result.p_WA) < 0.0 ? Side::right : Side::left;
    return result;
}

/// Within an octave every point of the curve moves in a straight line, so a part of the way moves
/// the attachments by the same part.
void Groove::change_level(RenderedOutlines& outlines, double level, const CaptureLaw& law) {
    const double from = outlines.level();
    if (level == from) return;
    if (!is_tied()) {
        outlines = RenderedOutlines(outlines.scene(), level);
        return;
    }
    const CurveSet& curves = outlines.scene().curves;
    const double goal = within_octave(from, level);
    double step = std::min(largest_octaves, std::abs(goal - from));
    for (int tries = 0; tries < 3; ++tries) {
        const bool is_whole_way = step >= std::abs(goal - from);
        const double to = is_whole_way ? goal : from + std::copysign(step, goal - from);
        RenderedOutlines after(outlines.scene(), to);
        double push_N = 0.0;
        std::array<Attachment, 2> both{now_, before_};
        for (Attachment& at : both) {
            if (!at.exists()) continue;
            const Position old = point_of(outlines, at);
            at = at_level(curves, at, from, to);
            push_N = std::max(push_N, law.steepest_N_per_m() * norm(point_of(after, at) - old));
        }
        if (push_N <= largest_level_push_N) {
            now_ = both[0];
            before_ = both[1];
            outlines = after;
            return;
        }
        step *= 0.95 * largest_level_push_N / push_N;
    }
}

/// A line beyond the capture width has no force and is given up; its share goes to no line.
void Groove::slide(RenderedOutlines& outlines, Position handle, const CaptureLaw& law,
                   double longest_m, double longest_hop_m) {
    for (Attachment* const at : {&now_, &before_}) {
        if (!at->exists()) continue;
        *at = slid(outlines, *at, handle, longest_m, longest_hop_m);
        if (!(norm(point_of(outlines, *at) - handle) < law.capture_m())) *at = {};
    }
    if (now_.exists() || !before_.exists()) return;
    now_ = before_;
    before_ = {};
    share_ = 1.0 - share_;
}

void Groove::look_for_nearer(RenderedOutlines& outlines, Position handle, const CaptureLaw& law,
                             const Budget& budget, double most_N, GrooveForce& result) {
    is_crowded_ = false;
    const bool was_tied = is_tied();
    // A handover ends before the next one begins; of two ridges, one must lose its share to a
    // third.
    if (was_tied && share_ < 1.0 && mode_ != Mode::ridge) return;
    double within_m = law.capture_m();
    for (const Attachment& at : {now_, before_}) {
        if (!at.exists()) continue;
        const double distance_m = norm(point_of(outlines, at) - handle);
        within_m = std::min(within_m, distance_m - handover_margin_m);
    }
    if (!(within_m > 0.0)) return;
    const Closest found = outlines.scene().tree.closest_point(outlines.scene().curves, handle,
                                                              outlines.level(), within_m, budget);
    result.boxes = found.boxes;
    result.is_complete = found.is_complete;
    if (found.segment.piece < 0) return;
    take_over({found.segment, found.parameter});
    if (was_tied) return;
    // The force comes on as the hand comes near, or gently if the line was found late.
    const double force_N = std::abs(law.pull_N(found.distance_m));
    share_ = is_fresh_ || force_N <= most_N ? 1.0 : most_N / force_N;
}

void Groove::take_over(const Attachment& found) {
    if (is_tied() && share_ > 0.0 && share_ < 1.0) {
        is_crowded_ = true;
        return;
    }
    if (share_ > 0.0) before_ = now_;
    now_ = found;
    share_ = 0.0;
}

Groove::Part Groove::part_of(RenderedOutlines& outlines, const Attachment& at, Position handle,
                             const CaptureLaw& law) const {
    if (!at.exists()) return {{}, law.energy_J(law.capture_m()), law.capture_m()};
    const Position to_line = point_of(outlines, at) - handle;
    const double distance_m = norm(to_line);
    return {along<Force>(direction_of(to_line), law.pull_N(distance_m)), law.energy_J(distance_m),
            distance_m};
}

double Groove::wanted_share(const Part& now, const Part& before) const {
    if (mode_ != Mode::ridge || !before_.exists()) return 1.0;
    const double nearer_m = before.distance_m - now.distance_m;
    if (is_crowded_) return nearer_m > 0.0 ? 1.0 : 0.0;
    return std::clamp(0.5 + 0.5 * nearer_m / valley_m, 0.0, 1.0);
}

void Groove::shift(const Part& now, const Part& before, double dt_s) {
    const double difference_N = norm(now.force - before.force);
    double step = dt_s / fade_s;
    if (difference_N * step > largest_fade_N) step = largest_fade_N / difference_N;
    share_ = std::clamp(wanted_share(now, before), share_ - step, share_ + step);
    if (share_ == 1.0 && mode_ != Mode::ridge) before_ = {};
}

/// Books the tick and finds the strength that it can afford.
void Groove::store(double energy_J, Position moved, double stiffness_N_per_m, double dt_s) {
    strength_ = std::min(1.0, strength_ + dt_s / recovery_s);
    if (is_fresh_) {
        energy_J_ = energy_J;
        return;
    }
    const double left_J = energy_J_ - dot(force_, moved);
    const double covered_J = left_J + 0.5 * stiffness_N_per_m * dot(moved, moved);
    const double most_J = covered_J + account_.balance_J();
    if (!(strength_ * energy_J <= most_J)) strength_ = std::max(0.0, most_J / energy_J);
    energy_J_ = std::min(strength_ * energy_J, most_J);
    (void)account_.spend(std::clamp(energy_J_ - covered_J, 0.0, account_.balance_J()));
    account_.earn(left_J - energy_J_, dt_s);
}

}  // namespace touchline
