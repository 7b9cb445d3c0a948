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
            Position low = points[first];
            Position high = low;
            for (const Position p : points.subspan(first, std::min(run, points.size() - first))) {
                low.x = std::min(low.x, p.x);
                low.y = std::min(low.y, p.y);
                high.x = std::max(high.x, p.x);
                high.y = std::max(high.y, p.y);
            }
            bounds_.push_back({low, high});
        }
    }

    [[nodiscard]] std::size_t near(Position place) const {
        std::size_t nearest_run = 0;
        for (std::size_t i = 1; i < bounds_.size(); ++i) {
            if (gap2_m2(i, place) < gap2_m2(nearest_run, place)) nearest_run = i;
        }
        const double enough_m2 = least_in(nearest_run, place).gap2_m2;
        Nearest nearest{0, INFINITY};
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            if (gap2_m2(i, place) > enough_m2) continue;
            const Nearest found = least_in(i, place);
            if (found.gap2_m2 < nearest.gap2_m2) nearest = found;
        }
        return nearest.vertex;
    }

  private:
    static constexpr std::size_t run = 64;

    struct Nearest {
        std::size_t vertex;
        double gap2_m2;
    };

    [[nodiscard]] double gap2_m2(std::size_t i, Position place) const {
        const auto& [low, high] = bounds_[i];
        const Position out{std::max({low.x - place.x, place.x - high.x, 0.0}),
                           std::max({low.y - place.y, place.y - high.y, 0.0})};
        return dot(out, out);
    }

    /// Looks at the vertices of one run.
    [[nodiscard]] Nearest least_in(std::size_t i, Position place) const {
        Nearest nearest{i * run, INFINITY};
        const std::size_t end = std::min((i + 1) * run, points_.size());
        for (std::size_t k = i * run; k < end; ++k) {
            const Position way = points_[k] - place;
            if (dot(way, way) < nearest.gap2_m2) nearest = {k, dot(way, way)};
        }
        return nearest;
    }

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
