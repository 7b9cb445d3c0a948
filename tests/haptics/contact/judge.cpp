#include "tests/haptics/contact/judge.h"

#include "tests/exact/orientation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchline {
namespace {

double distance_to(Position p, const Segment& s) {
    const Position e = s.b - s.a;
    const double t = std::clamp(dot(p - s.a, e) / dot(e, e), 0.0, 1.0);
    return norm(p - (s.a + t * e));
}

}  // namespace

Judge::Judge(const CurveSet& curves, double level, double cell_m) : cell_m_(cell_m) {
    for (int piece = 0; piece < static_cast<int>(curves.pieces().size()); ++piece) {
        for (int j = 0; j < curves.rendered_count(piece, level); ++j) {
            segments_.push_back(curves.rendered_segment(piece, level, j));
        }
    }
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const Segment& s = segments_[i];
        for (double x = std::floor(std::min(s.a.x, s.b.x) / cell_m_);
             x * cell_m_ <= std::max(s.a.x, s.b.x); x += 1) {
            for (double y = std::floor(std::min(s.a.y, s.b.y) / cell_m_);
                 y * cell_m_ <= std::max(s.a.y, s.b.y); y += 1) {
                cells_[key({(x + 0.5) * cell_m_, (y + 0.5) * cell_m_})].push_back(i);
            }
        }
    }
}

std::int64_t Judge::key(Position p) const {
    return static_cast<std::int64_t>(std::floor(p.x / cell_m_)) * 1000003 +
           static_cast<std::int64_t>(std::floor(p.y / cell_m_));
}

std::vector<std::uint32_t> Judge::near(Position a, Position b, double reach_m) const {
    std::vector<std::uint32_t> found;
    const auto low = [&](double u, double v) {
        return std::floor((std::min(u, v) - reach_m) / cell_m_);
    };
    for (double x = low(a.x, b.x); x * cell_m_ <= std::max(a.x, b.x) + reach_m; x += 1) {
        for (double y = low(a.y, b.y); y * cell_m_ <= std::max(a.y, b.y) + reach_m; y += 1) {
            const auto cell = cells_.find(key({(x + 0.5) * cell_m_, (y + 0.5) * cell_m_}));
            if (cell != cells_.end())
                found.insert(found.end(), cell->second.begin(), cell->second.end());
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

bool Judge::is_free(Position a, Position b) const {
    const auto candidates = near(a, b, 0.0);
    return std::none_of(candidates.begin(), candidates.end(), [&](std::uint32_t i) {
        return exact::meet(a, b, segments_[i].a, segments_[i].b);
    });
}

bool Judge::is_free(std::span<const Position> path) const {
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (!is_free(path[i - 1], path[i])) return false;
    }
    return true;
}

double Judge::distance_m(Position p, double within_m) const {
    double nearest = within_m;
    for (const std::uint32_t i : near(p, p, within_m)) {
        nearest = std::min(nearest, distance_to(p, segments_[i]));
    }
    return nearest;
}

double Judge::possible_gain_m(Position proxy, Position handle) const {
    std::vector<Direction> ways{direction_of(handle - proxy)};
    for (const std::uint32_t i : near(proxy, proxy, 1e-3)) {
        const Direction u = direction_of(segments_[i].b - segments_[i].a);
        ways.push_back(u);
        ways.push_back(-u);
    }
    for (int k = 0; k < 72; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 72.0;
        ways.push_back({std::cos(angle), std::sin(angle)});
    }
    double gain = 0.0;
    const double now = norm(handle - proxy);
    for (const double length : {1e-8, 1e-6, 1e-4}) {
        for (const Direction u : ways) {
            const Position there = proxy + along<Position>(u, length);
            const double cut = now - norm(handle - there);
            if (cut > gain && is_free(proxy, there)) gain = cut;
        }
    }
    return gain;
}

}  // namespace touchline
