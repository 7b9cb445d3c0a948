// A picture of one line across the drawing area, for feeling. Threads: plain values.
#pragma once

#include "app/force/servo/scene_order.h"
#include "app/force/servo/servo_client.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace touchline {

/// A line at height y_m. Another version makes another picture.
[[nodiscard]] inline FeltPicture felt_line(double y_m, std::uint64_t version) {
    TactileMap map;
    Outline line;
    line.points = {{-0.05, y_m}, {0.0, y_m}, {0.05, y_m}};
    map.outlines.push_back(line);
    map.version = version;
    const SceneOrder order{};
    auto scene = build_scene(map, order).value();
    return {std::make_shared<const Scene>(std::move(scene)),
            std::make_shared<const TactileMap>(std::move(map)),
            order,
            {}};
}

}  // namespace touchline
