#include "vision/contour/junctions.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace touchline {

void JunctionSet::add_cluster(std::vector<EndId> ends, cv::Point2d centre) {
    junctions_.push_back({centre, std::move(ends), false});
}

void JunctionSet::add_meeting(EndId end, PointRef host) {
    cuts_.push_back({host, junctions_.size()});
    junctions_.push_back({{}, {end}, true});
}

std::vector<Chain> JunctionSet::assembled(std::vector<Chain> lines) {
    arms_ = std::move(lines);
    moved_.resize(2 * arms_.size());
    for (EndId end = 0; end < moved_.size(); ++end) moved_[end] = end;
    cut_hosts();
    partner_.assign(2 * arms_.size(), no_end);
    for (const auto& [a, b] : joints_) join(moved_[a], moved_[b]);
    for (Junction& junction : junctions_) place(junction);
    for (const SolvedJunction& junction : solved_) pin(junction);
    is_walked_.assign(arms_.size(), false);
    std::vector<Chain> outlines;
    for (const bool from_ends : {true, false}) {  // first the open ones; the rest are rings
        for (std::size_t arm = 0; arm < arms_.size(); ++arm) {
            for (const EndId end : {front_of(arm), back_of(arm)}) {
                if (!is_walked_[arm] && (!from_ends || partner_[end] == no_end)) {
                    outlines.push_back(walked(end));
                }
            }
        }
    }
    return outlines;
}

void JunctionSet::cut_hosts() {
    std::map<std::size_t, std::vector<Cut>> by_host;
    for (const Cut& c : cuts_) by_host[c.host.chain].push_back(c);
    for (auto& [host, cuts] : by_host) {
        std::ranges::stable_sort(cuts, {}, [](const Cut& c) { return c.host.index; });
        // Meetings closer together than the blur are one junction: a crossing, seen from both
        // sides.
        const std::vector<EdgePoint>& points = arms_[host].points;
        std::vector<Cut> apart;
        for (const Cut& c : cuts) {
            if (!apart.empty() && distance(points[apart.back().host.index].at,
                                           points[c.host.index].at) <= blur_px_ + 1.0) {
                Junction& same = junctions_[apart.back().junction];
                same.arms.push_back(junctions_[c.junction].arms.front());
                junctions_[c.junction].arms.clear();
            } else {
                apart.push_back(c);
                junctions_[c.junction].at = points[c.host.index].at;
            }
        }
        cut(host, apart);
    }
    for (Junction& junction : junctions_) {
        for (EndId& end : junction.arms) end = moved_[end];
    }
    for (const auto& [junction, end] : host_arms_) junctions_[junction].arms.push_back(end);
    std::erase_if(junctions_, [](const Junction& j) { return j.arms.empty(); });
}

/// The first piece stays in the line's place; the others are appended.
void JunctionSet::cut(std::size_t host, const std::vector<Cut>& cuts) {
    Chain line = std::move(arms_[host]);
    std::size_t offset = 0;
    if (line.is_closed) {
        offset = cuts.front().host.index;
        begin_at(offset, line.points);
        line.points.push_back(line.points.front());
    }
    const auto part = [&](std::size_t from, std::size_t to) {
        return Chain{part_of(line.points, from, to + 1), false, line.width_px, line.of};
    };
    std::size_t piece = host;
    std::size_t from = 0;
    for (std::size_t k = line.is_closed ? 1 : 0; k < cuts.size(); ++k) {
        const std::size_t to = cuts[k].host.index - offset;
        arms_[piece] = part(from, to);
        host_arms_.emplace_back(cuts[k].junction, back_of(piece));
        arms_.emplace_back();
        piece = arms_.size() - 1;
        host_arms_.emplace_back(cuts[k].junction, front_of(piece));
        from = to;
    }
    arms_[piece] = part(from, line.points.size() - 1);
    if (line.is_closed) {
        host_arms_.emplace_back(cuts.front().junction, front_of(host));
        host_arms_.emplace_back(cuts.front().junction, back_of(piece));
    } else {
        moved_[back_of(host)] = back_of(piece);
    }
}

Ray JunctionSet::ray_of(EndId end) const {
    return ray_at(arms_[chain_of(end)].points, is_back(end), blur_px_, span_px_);
}

/// On a line that runs straight through, the junction stays on it; else it lies where all arms
/// point.
void JunctionSet::place(Junction& junction) {
    std::vector<Ray> rays;
    double straightest = std::numbers::pi;
    for (const EndId end : junction.arms) {
        rays.push_back(ray_of(end));
        for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
            straightest = std::min(straightest, turn(rays[i], rays.back()));
        }
    }
    const bool is_moved = !junction.is_on_line || straightest > straight_on_rad;
    if (is_moved) junction.at = place_of(rays, junction.at);
    join_through(junction.arms, rays);
    pin_arms(junction, is_moved);
}

/// Returns where the arms' lines cross; `otherwise` if that is far away or undetermined.
cv::Point2d JunctionSet::place_of(const std::vector<Ray>& rays, cv::Point2d otherwise) const {
    constexpr double least_determinant = 0.05;
    const auto crossing = crossing_of(rays, least_determinant);
    return crossing && distance(*crossing, otherwise) <= 2.0 * blur_px_ + 1.0 ? *crossing
                                                                              : otherwise;
}

void JunctionSet::join_through(const std::vector<EndId>& ends, const std::vector<Ray>& rays) {
    struct Pair {
        double angle;
        std::size_t i, j;
    };

    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const double angle = turn(rays[i], rays[j]);
            if (angle < straight_on_rad) pairs.push_back({angle, i, j});
        }
    }
    std::ranges::stable_sort(pairs, {}, &Pair::angle);
    std::vector<bool> is_joined(ends.size(), false);
    for (const Pair& pair : pairs) {
        if (!is_joined[pair.i] && !is_joined[pair.j]) {
            join(ends[pair.i], ends[pair.j]);
            is_joined[pair.i] = true;
            is_joined[pair.j] = true;
        }
    }
}

/// Ends every arm in the junction's point. If the point has moved, removes the bent stretch before
/// it.
void JunctionSet::pin_arms(const Junction& junction, bool is_moved) {
    for (const EndId end : junction.arms) {
        std::vector<EdgePoint>& points = arms_[chain_of(end)].points;
        if (!is_back(end)) std::ranges::reverse(points);
        EdgePoint last = points.back();
        last.at = junction.at;
        last.is_fixed = true;
        while (is_moved && points.size() > 1 &&
               distance(points.back().at, junction.at) < blur_px_) {
            points.pop_back();
        }
        if (points.size() > 1 && points.back().at == junction.at) points.pop_back();
        points.push_back(last);
        if (!is_back(end)) std::ranges::reverse(points);
    }
}

void JunctionSet::pin(const SolvedJunction& junction) {
    for (const auto& [a, b] : junction.through) join(moved_[a], moved_[b]);
    for (const SolvedJunction::Arm& arm : junction.arms) {
        const EndId end = moved_[arm.end];
        std::vector<EdgePoint>& points = arms_[chain_of(end)].points;
        if (is_back(end)) std::ranges::reverse(points);
        EdgePoint first = points.front();
        first.at = junction.at;
        first.is_fixed = true;
        std::size_t gone = 1;
        for (double passed_px = 0.0; gone < points.size() && passed_px < arm.bent_px; ++gone) {
            passed_px += distance(points[gone - 1].at, points[gone].at);
        }
        points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(
                                                          std::min(gone, points.size() - 1)));
        points.insert(points.begin(), first);
        if (is_back(end)) std::ranges::reverse(points);
    }
}

void JunctionSet::join(EndId a, EndId b) {
    partner_[a] = b;
    partner_[b] = a;
}

/// Walks from an end through its arm and all that is joined to it, to the last end or round to the
/// first.
Chain JunctionSet::walked(EndId start) {
    Chain line;
    EndId in = start;
    while (in != no_end && !is_walked_[chain_of(in)]) {
        Chain& arm = arms_[chain_of(in)];
        is_walked_[chain_of(in)] = true;
        line.width_px = std::max(line.width_px, arm.width_px);
        line.of = arm.of;
        if (arm.is_closed) return std::move(arm);
        if (is_back(in)) std::ranges::reverse(arm.points);
        const bool is_shared =
            !line.points.empty() && line.points.back().at == arm.points.front().at;
        line.points.insert(line.points.end(), arm.points.begin() + (is_shared ? 1 : 0),
                           arm.points.end());
        in = partner_[in ^ 1U];
    }
    line.is_closed = in == start && line.points.size() > 3;
    if (line.is_closed && line.points.front().at == line.points.back().at) line.points.pop_back();
    return line;
}

}  // namespace touchline
