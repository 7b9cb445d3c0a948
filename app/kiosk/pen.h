// The pointer as a pen: a mouse, a graphics tablet or a touch screen, all of which the window tells
// as a pointer with buttons.
// Threads: plain values.
#pragma once

#include "app/visit/visit_events.h"
#include "config/types/tactile_map.h"
#include "config/types/vec2.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace touchline {

enum class PenMotion : std::uint8_t { press, move, lift };

/// What the pen did, in W; beside the drawing area too.
struct PenChange {
    PenMotion motion = PenMotion::move;
    Position place_W;
    bool is_eraser = false;  // of a press and a lift: the second button
};

class Pen {
  public:
    /// Follows the pen over an area. Returns the stroke when the pen is lifted, an eraser's already
    /// when it is pressed. A press beside the area draws nothing, nor does one that is not finite.
    /// A stroke longer than most_way_m is kept up to there, and with one point beyond.
    [[nodiscard]] std::optional<PenStroke> step(const PenChange& change, const Area& area);

    /// Forgets the stroke that is under way.
    void drop();

    [[nodiscard]] bool is_down() const { return !line_.empty(); }

    /// The stroke that is under way (W); empty while the pen is up.
    [[nodiscard]] const std::vector<Position>& line() const { return line_; }

  private:
    void add(Position place_W);

    std::vector<Position> line_;
    double way_m_ = 0.0;  // of the line
};

}  // namespace touchline
