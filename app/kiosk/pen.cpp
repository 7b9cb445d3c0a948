#include "app/kiosk/pen.h"

#include "app/documents/drawing/drawing.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

// A pen that trembles in one place goes no way; a finger tells nothing that is so near.
constexpr double least_step_m = 1e-4;

bool is_in(Position p_W, const Area& area) {
    return std::abs(p_W.x) <= area.width_m / 2.0 && std::abs(p_W.y) <= area.height_m / 2.0;
}

}  // namespace

std::optional<PenStroke> Pen::step(const PenChange& change, const Area& area) {
    switch (change.motion) {
        case PenMotion::press:
            drop();
            if (!is_in(change.place_W, area)) break;
            if (change.is_eraser) return PenStroke{{change.place_W}, true};
            add(change.place_W);
            break;
        case PenMotion::move:
            if (is_down()) add(change.place_W);
            break;
        case PenMotion::lift:
            if (is_down() && !change.is_eraser) {
                way_m_ = 0.0;
                return PenStroke{std::exchange(line_, {})};
            }
            break;
    }
    return std::nullopt;
}

void Pen::drop() {
    line_.clear();
    way_m_ = 0.0;
}

/// One point beyond the bounds stays, so that the drawing refuses the stroke and says why.
void Pen::add(Position place_W) {
    if (!is_finite(place_W) || line_.size() > most_stroke_points || !(way_m_ <= most_way_m)) return;
    const double step_m = line_.empty() ? 0.0 : norm(place_W - line_.back());
    if (!line_.empty() && step_m < least_step_m) return;
    line_.push_back(place_W);
    way_m_ += step_m;
}

}  // namespace touchline
