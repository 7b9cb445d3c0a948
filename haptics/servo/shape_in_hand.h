// The shapes that may be held, and the proxy of the one that is. It is the only part of the servo's
// step that is not one flat value. Threads: one, the servo's, except for the constructor.
#pragma once

#include "config/types/held_shape.h"
#include "haptics/collision/scene.h"
#include "haptics/probe/probe_proxy.h"
#include "haptics/probe/probe_shape.h"

#include <vector>

namespace touchline {

class ShapeInHand {
  public:
    /// Builds the shapes and allocates all memory that steps need.
    ShapeInHand();

    /// Takes another shape in hand, or the same one anew, in a scene that must outlive its use. No
    /// allocation.
    void take(HeldShape shape, const Scene& scene, const ProbePose& handle, double level) {
        proxy_.reset(shape_of(shape), scene, handle, level);
    }

    [[nodiscard]] ProbeReport step(const ProbePose& handle, double level, double stiffness_N_per_m,
                                   const Budget& budget, double dt_s) {
        return proxy_.step(handle, level, {stiffness_N_per_m, 0.0}, budget, dt_s);
    }

    [[nodiscard]] double rendered_level() const { return proxy_.rendered_level(); }

    [[nodiscard]] const ProbeShape& shape_of(HeldShape shape) const {
        return shapes_[static_cast<std::size_t>(shape)];
    }

  private:
    std::vector<ProbeShape> shapes_;  // by HeldShape
    ProbeProxy proxy_;
};

}  // namespace touchline
