#include "tests/lab/bench/curve/simplify.h"

#include "haptics/curve/segment.h"

#include <algorithm>
#include <queue>
#include <set>
#include <utility>

namespace touchline::bench {
namespace {

/// A stretch between two kept points, and its point farthest from the chord.
struct Chord {
    double deviation_m = -1.0;
    std::size_t first = 0;
    std::size_t farthest = 0;
    std::size_t last = 0;

    friend bool operator<(const Chord& a, const Chord& b) { return a.deviation_m < b.deviation_m; }
};

Chord chord(const std::vector<Position>& points, std::size_t first, std::size_t last) {
    Chord made{-1.0, first, first, last};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double deviation = foot(points[i], {points[first], points[last]}).distance_m;
        if (deviation > made.deviation_m) {
            made.deviation_m = deviation;
            made.farthest = i;
        }
    }
    return made;
}

/// The remaining points, as a list, and those of least area first.
class Triangles {
  public:
    explicit Triangles(const std::vector<Position>& points) : points_(points) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            before_.push_back(i - 1);
            after_.push_back(i + 1);
            area_.push_back(0.0);
        }
        for (std::size_t i = 1; i + 1 < points.size(); ++i) insert(i);
    }

    void remove_least() {
        const auto [area, gone] = *by_area_.begin();
        by_area_.erase(by_area_.begin());
        const std::size_t a = before_[gone];
        const std::size_t b = after_[gone];
        after_[a] = b;
        before_[b] = a;
        for (const std::size_t near : {a, b}) {
            if (near == 0 || near + 1 == points_.size()) continue;
            by_area_.erase({area_[near], near});
            insert(near, area);
        }
    }

    [[nodiscard]] std::vector<std::size_t> left() const {
        std::vector<std::size_t> kept;
        for (std::size_t i = 0; i < points_.size(); i = after_[i]) kept.push_back(i);
        return kept;
    }

  private:
    /// No area counts for less than that of a point removed before.
    void insert(std::size_t i, double least = 0.0) {
        const Position a = points_[before_[i]] - points_[i];
        const Position b = points_[after_[i]] - points_[i];
        area_[i] = std::max(least, 0.5 * std::abs(cross(a, b)));
        by_area_.insert({area_[i], i});
    }

    const std::vector<Position>& points_;
    std::vector<std::size_t> before_, after_;
    std::vector<double> area_;
    std::set<std::pair<double, std::size_t>> by_area_;
};

}  // namespace

std::vector<std::size_t> douglas_peucker(const std::vector<Position>& points, std::size_t count) {
    const std::size_t end = points.size() - 1;
    std::vector<std::size_t> kept{0, end};
    std::priority_queue<Chord> chords;
    chords.push(chord(points, 0, end));
    while (kept.size() < count) {
        const Chord worst = chords.top();
        chords.pop();
        kept.push_back(worst.farthest);
        chords.push(chord(points, worst.first, worst.farthest));
        chords.push(chord(points, worst.farthest, worst.last));
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

std::vector<std::size_t> visvalingam(const std::vector<Position>& points, std::size_t count) {
    Triangles triangles(points);
    for (std::size_t left = points.size(); left > count; --left) triangles.remove_least();
    return triangles.left();
}

}  // namespace touchline::bench
