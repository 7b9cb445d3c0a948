// What is felt and seen.
// Threads: a value that shares what does not change.
#pragma once

#include "app/screen/canvas.h"
#include "haptics/collision/scene.h"

#include <memory>

namespace touchline {

/// Empty before the first picture.
struct ShownScene {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const Canvas> picture;
};

}  // namespace touchline
