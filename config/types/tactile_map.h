// The immutable picture as felt. vision and haptics meet only here.
#pragma once

#include "config/types/vec2.h"

#include <cstdint>
#include <string>
#include <vector>

namespace touchline {

/// The drawing area: a rectangle centred on the origin of W.
struct Area {
    double width_m =
        0.116;  // > 0; default: the largest 4:3 box of a 2diy gen 3 with condition <= 3
    double height_m = 0.084;

    friend bool operator==(const Area&, const Area&) = default;
};

/// A polyline in W. If closed, the last point joins the first, which is not repeated.
struct Outline {
    std::vector<Position> points;  // >= 2 points, all finite
    bool is_closed = false;
    std::string id;       // unique in its map; may be empty
    std::string label;    // the name of the part, for speech; may be empty
    double weight = 1.0;  // importance, > 0
    int detail = 1;       // lowest detail (1 silhouette ... 5 all) at which it is shown
};

/// A text tied to a place in W.
struct Label {
    std::string text;
    Position place;
};

struct TactileMap {
    Area area;
    std::vector<Outline> outlines;
    std::vector<Label> labels;
    std::string title;
    std::string description;
    std::uint64_t version = 0;  // changes with every new map; nothing mixes versions
    std::uint64_t drawing = 0;  // maps of one drawing that grows line by line share it; 0: none
};

}  // namespace touchline
