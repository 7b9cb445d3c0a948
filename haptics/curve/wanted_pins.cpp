#include "haptics/curve/curve_set.h"

#include <algorithm>
#include <cmath>

namespace touchline {
namespace {

/// Finds the vertex nearest to a place, the first of several. It passes over runs of vertices whose
/// bounds are too far away.
class NearestVertex {
  public:
    explicit NearestVertex(std::span<const Position> points) : points_(points) {
        for (std::size_t first = 0; first < points.size(); first += run) {
            Bounds bounds{points[first], points[first]};
            for (const Position p : points.subspan(first, std::min(run, points.size() - first))) {
                bounds.low = {std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y)};
                bounds.high = {std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y)};
            }
            bounds_.push_back(bounds);
        }
    }

    [[nodiscard]] std::size_t near(Position place) const {
        std::size_t nearest = 0;
        double least_m2 = INFINITY;
        for (std::size_t i = 0; i < bounds_.size() && least_m2 > 0.0; ++i) {
            const auto& [low, high] = bounds_[i];
            const Position out{std::max({low.x - place.x, place.x - high.x, 0.0}),
                               std::max({low.y - place.y, place.y - high.y, 0.0})};
            if (dot(out, out) >= least_m2) continue;
            const std::size_t end = std::min((i + 1) * run, points_.size());
            for (std::size_t k = i * run; k < end; ++k) {
                const Position way = points_[k] - place;
                if (dot(way, way) >= least_m2) continue;
                least_m2 = dot(way, way);
                nearest = k;
            }
        }
        return nearest;
    }

  private:
    static constexpr std::size_t run = 64;

    struct Bounds {
        Position low, high;
    };

    std::span<const Position> points_;
    std::vector<Bounds> bounds_;
};

}  // namespace

void add_pins(const std::vector<Outline>& outlines, std::span<const PinPlace> wanted,
              std::vector<std::vector<std::size_t>>& pins) {
    std::vector<PinPlace> places(wanted.begin(), wanted.end());
    std::ranges::stable_sort(places, {}, &PinPlace::outline);
    for (auto pin = places.begin(); pin != places.end();) {
        const auto outline = static_cast<std::size_t>(pin->outline);
        const NearestVertex vertices(outlines[outline].points);
        std::vector<std::size_t>& own = pins[outline];
        for (; pin != places.end() && pin->outline == static_cast<int>(outline); ++pin) {
            if (!outlines[outline].points.empty()) own.push_back(vertices.near(pin->place));
        }
        std::ranges::sort(own);
        own.erase(std::unique(own.begin(), own.end()), own.end());
    }
}

}  // namespace touchline
