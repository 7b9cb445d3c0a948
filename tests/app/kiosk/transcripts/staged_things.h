// What lies under the camera and on the stick in the recorded visits: the same on every machine.
// Threads: one.
#pragma once

#include "app/loading/kiosk_stages.h"
#include "app/loading/stages.h"
#include "vision/camera/camera.h"

#include <memory>
#include <vector>

namespace touchline {

/// A camera above a photograph of a dark, round thing. It can be unplugged.
class StagedCamera final : public Camera {
  public:
    [[nodiscard]] std::vector<CameraName> list() override { return {}; }

    void choose(const std::string& /*id*/) override {}

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override { return std::nullopt; }

    void want_still() override { is_wanted_ = true; }

    [[nodiscard]] CameraView step(double now_s) override;

  private:
    bool is_wanted_ = false;
    std::optional<double> due_s_;
};

/// Takes the thing in the middle for a dog, and finds nothing anywhere else.
[[nodiscard]] ThingFinder staged_finder();

/// A document of three pages, and a file that is no document.
[[nodiscard]] std::vector<FilePtr> staged_files();

}  // namespace touchline
