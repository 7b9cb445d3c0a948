// Geometry on which rendered walls go wrong, and the hand that presses on it: the motions of the
// stability scenarios (tests/haptics/contact/scenarios). Threads: values.
#pragma once

#include "tests/haptics/contact/scenarios/plant.h"
#include "tests/lab/bench/collision/crossing.h"

#include <functional>
#include <string>
#include <vector>

namespace touchline::bench {

struct Torture {
    std::string group;
    std::string name;
    /// One closed curve. It runs along open lines and crossings there and back, so that the plain
    /// proxy, which knows one curve, has the same edges twice.
    std::vector<Position> ring;
    std::vector<scenarios::Polyline> lines;  // the same lines, once
    scenarios::Trajectory hand;
    double end_s = 0.0;
    /// Whether the proxy, last seen at the first place, came to the second through a line.
    std::function<bool(Position from, Position to)> is_through;
    bool has_room = false;  // for a disc of 2 mm
};

/// Returns a closed curve over an open line, in metres.
[[nodiscard]] std::vector<Position> there_and_back(const scenarios::Polyline& line);

/// Returns acute corners (5), thin bars (4), crossing lines (4), line ends (2).
[[nodiscard]] std::vector<Torture> tortures();

}  // namespace touchline::bench
