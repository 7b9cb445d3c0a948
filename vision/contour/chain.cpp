#include "vision/contour/chain.h"

#include <cmath>

namespace touchline {
namespace {

constexpr int spacing_passes = 2;  // of (1 2 1)/4: a Gaussian of one spacing

/// Smooths the inner points binomially.
void smooth(std::vector<EdgePoint>& line) {
    for (int pass = 0; pass < spacing_passes; ++pass) {
        cv::Point2d before = line.front().at;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            const cv::Point2d here = line[i].at;
            line[i].at = 0.25 * (before + 2.0 * here + line[i + 1].at);
            before = here;
        }
    }
}

std::vector<EdgePoint> even_run(const std::vector<EdgePoint>& run, double spacing_px,
                                int least_segments) {
    const double length = length_of({run, false});
    const int n = std::max(least_segments, static_cast<int>(std::lround(length / spacing_px)));
    std::vector<EdgePoint> even = evenly_spaced(run, n);
    smooth(even);
    return even;
}

/// A ring without a fixed point: sampled from its first point, smoothed all round.
Chain even_ring(std::vector<EdgePoint> ring, double spacing_px) {
    constexpr int overlap = spacing_passes;
    ring.push_back(ring.front());
    const double length = length_of({ring, false});
    const int n = std::max(4, static_cast<int>(std::lround(length / spacing_px)));
    std::vector<EdgePoint> even = evenly_spaced(ring, n);
    even.pop_back();
    std::vector<EdgePoint> round;
    for (int i = -overlap; i < n + overlap; ++i) {
        round.push_back(even[static_cast<std::size_t>((i + n) % n)]);
    }
    smooth(round);
    return {{round.begin() + overlap, round.end() - overlap}, true};
}

}  // namespace

std::vector<double> arc_lengths(const std::vector<EdgePoint>& points) {
    std::vector<double> lengths{0.0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        lengths.push_back(lengths.back() + distance(points[i - 1].at, points[i].at));
    }
    return lengths;
}

Ray ray_at(const std::vector<EdgePoint>& line, bool at_back, double skip_px, double span_px) {
    const std::size_t n = line.size();
    const auto at = [&](std::size_t i) { return line[at_back ? n - 1 - i : i].at; };
    std::size_t near = 0;
    std::size_t far = 0;
    double passed = 0.0;
    for (std::size_t i = 1; i < n && passed < skip_px + span_px; ++i) {
        passed += distance(at(i - 1), at(i));
        far = i;
        near = passed <= skip_px ? i : near;
    }
    if (near == far && near > 0) {  // shorter than the skip: its whole length
        near = 0;
    }
    const cv::Point2d along = at(near) - at(far);
    const double length = cv::norm(along);
    return {at(near), length > 0.0 ? along / length : cv::Point2d(1.0, 0.0)};
}

double angle_between(const cv::Point2d& a, const cv::Point2d& b) {
    return std::abs(std::atan2(a.cross(b), a.dot(b)));
}

double turn(const Ray& in, const Ray& out) {
    return angle_between(in.direction, -out.direction);
}

std::optional<cv::Point2d> crossing_of(const std::vector<Ray>& rays, double least) {
    cv::Matx22d a = cv::Matx22d::zeros();
    cv::Vec2d b(0.0, 0.0);
    for (const Ray& ray : rays) {
        const cv::Vec2d d(ray.direction.x, ray.direction.y);
        const cv::Matx22d across = cv::Matx22d::eye() - d * d.t();
        a += across;
        b += across * cv::Vec2d(ray.from.x, ray.from.y);
    }
    if (!(cv::determinant(a) >= least)) return std::nullopt;
    const cv::Vec2d solution = a.inv() * b;
    return cv::Point2d(solution[0], solution[1]);
}

PointGrid::PointGrid(const std::vector<Chain>& chains, cv::Size picture, double cell_px)
    : cell_px_(cell_px),
      columns_(static_cast<int>(picture.width / cell_px) + 1),
      rows_(static_cast<int>(picture.height / cell_px) + 1),
      start_(static_cast<std::size_t>(columns_ * rows_) + 1, 0) {
    for (const Chain& chain : chains) {
        for (const EdgePoint& point : chain.points) ++start_[cell_of(point.at) + 1];
    }
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    refs_.resize(start_.back());
    std::vector<std::size_t> next = start_;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        for (std::size_t i = 0; i < chains[c].points.size(); ++i) {
            refs_[next[cell_of(chains[c].points[i].at)]++] = {c, i};
        }
    }
}

int PointGrid::column(double x) const {
    return std::clamp(static_cast<int>(std::floor(x / cell_px_)), 0, columns_ - 1);
}

int PointGrid::row(double y) const {
    return std::clamp(static_cast<int>(std::floor(y / cell_px_)), 0, rows_ - 1);
}

std::size_t PointGrid::cell_of(const cv::Point2d& p) const {
    return static_cast<std::size_t>(row(p.y) * columns_ + column(p.x));
}

std::vector<EdgePoint> evenly_spaced(const std::vector<EdgePoint>& line, int n) {
    if (line.empty()) return {};
    const double step = length_of({line, false}) / n;
    std::vector<EdgePoint> even;
    even.reserve(static_cast<std::size_t>(n) + 1);
    even.push_back(line.front());
    double passed = 0.0;  // arc length up to line[i - 1]
    for (std::size_t i = 1; i < line.size(); ++i) {
        const EdgePoint& a = line[i - 1];
        const EdgePoint& b = line[i];
        const double piece = distance(a.at, b.at);
        while (piece > 0.0 && static_cast<int>(even.size()) < n &&
               passed + piece >= step * static_cast<double>(even.size())) {
            const double t = (step * static_cast<double>(even.size()) - passed) / piece;
            even.push_back({a.at + t * (b.at - a.at), a.strength + t * (b.strength - a.strength)});
        }
        passed += piece;
    }
    while (static_cast<int>(even.size()) < n) {
        even.push_back(line.back());
        even.back().is_fixed = false;
    }
    even.push_back(line.back());
    return even;
}

Chain resampled(const Chain& chain, double spacing_px) {
    if (is_free_ring(chain)) return even_ring(chain.points, spacing_px);
    return with_runs_changed(chain, [&](const std::vector<EdgePoint>& run) {
        // A closed outline needs three points, whatever its size.
        const bool is_whole_ring = run.size() > chain.points.size();
        return even_run(run, spacing_px, is_whole_ring ? 4 : 1);
    });
}

}  // namespace touchline
