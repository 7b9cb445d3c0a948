#include "haptics/servo/shape_in_hand.h"

#include "haptics/probe/held_shapes.h"

namespace touchline {

ShapeInHand::ShapeInHand() {
    for (std::size_t i = 0; i < held_shape_count; ++i)
        shapes_.push_back(held_shape(static_cast<HeldShape>(i)));
    proxy_.reserve();
}

}  // namespace touchline
