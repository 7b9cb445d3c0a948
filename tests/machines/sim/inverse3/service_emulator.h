// The maker's service as its clients see it: JSON texts in and out, with the arm's mechanics and a
// hand behind it; the caller passes time in. One library serves every way to reach it: in the same
// process (emulated_service.h) or through a socket (service_server.h). Threads: one at a time.
#pragma once

#include "haptics/device/inverse3/inverse3_frames.h"
#include "haptics/device/simulated/simulated_pantograph.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A device on the service, whatever a client believes.
struct ArmTruth {
    std::string name = "04EA";
    std::string type = "inverse3";
    bool has_power = true;
    bool is_calibrated = true;
    bool is_ready = true;
    bool is_mount_turned = false;
    bool has_workspace_scaled = false;
    bool tells_place = true;
};

struct ServiceTruth {
    std::vector<ArmTruth> arms{ArmTruth{}};
    bool has_session = true;  // as services from 3.5 on
    /// From the last command to no force. The maker does not say how long.
    double idle_after_s = 0.1;
    bool clings = false;  // it goes on applying the last force that is not zero, and says so
    Space centre_m{0.0, -0.13, 0.15};  // where the path's origin is
    HandModel hand = normal_hand;
    TipParameters tip;
    double weight_N = 0.0;  // with which the hand rests on the handle
};

/// What the service applies, from a moment on.
struct AppliedForce {
    double at_s = 0.0;
    Space force_N;
};

class ServiceEmulator {
  public:
    /// The hand follows the path, in the frame of a picture, and means to stay at one height.
    ServiceEmulator(ServiceTruth truth, std::shared_ptr<const IntendedPath> path);

    /// Never goes back.
    void advance_to(double t_s);

    [[nodiscard]] double now_s() const { return now_s_; }

    // What a client sees. The first device is the one with mechanics; the others stand still.

    /// The frame that comes unasked.
    [[nodiscard]] std::string greet() const { return frame(true); }

    /// Takes a client's frame and returns the one answer to it.
    [[nodiscard]] std::string answer(std::string_view text);

    /// A client's end: its session's force with it.
    void leave() { apply({}); }

    // What people do.

    [[nodiscard]] ArmTruth& arm(std::size_t index = 0) { return truth_.arms.at(index); }

    void unplug() { truth_.arms.clear(); }

    /// The hand means to be this much above the path's plane.
    void lift(double height_m) { height_m_ = height_m; }

    // What only a test can see.

    [[nodiscard]] Space place_m() const;

    [[nodiscard]] Space applied_N() const { return applied_N_; }

    [[nodiscard]] const std::vector<AppliedForce>& told_forces() const { return told_; }

  private:
    [[nodiscard]] std::string frame(bool is_whole) const;
    void apply(Space force_N);
    void step(double span_s);

    ServiceTruth truth_;
    std::shared_ptr<const IntendedPath> path_;
    TipDynamics level_;     // x and y, from the centre
    TipDynamics vertical_;  // z, as x
    double height_m_ = 0.0;
    Space applied_N_;
    double told_s_ = 0.0;
    double now_s_ = 0.0;
    std::vector<AppliedForce> told_;
};

}  // namespace touchline
