#include "tests/haptics/device/conformance/rigs.h"

#include "haptics/device/drives/motor_pair.h"

#include <array>

namespace touchline {
namespace {

/// The board's counts are a quarter of a millimetre at the tip, and its duty has 255 steps.
RigPromises of_the_board() {
    RigPromises promises;
    promises.place_m = 6e-4;
    return promises;
}

/// It knows by itself where its handle is, and its service goes idle when a client leaves.
RigPromises of_the_inverse3() {
    RigPromises promises;
    promises.place_m = 2e-4;
    promises.silence_s = 20e-3;  // the session's, a tick and a frame's way
    promises.needs_opening = false;
    promises.free_s = 0.001;
    promises.alone_s = promises.silence_s;
    return promises;
}

/// In software there is no line: it can only be taken away.
RigPromises of_the_simulated_pantograph() {
    RigPromises promises;
    promises.place_m = 6e-4;
    promises.loss_s = 0.0;
    promises.silence_s = 3e-3;  // its motors' delay
    promises.needs_opening = false;
    promises.keeps_way = false;
    promises.has_motors = false;
    return promises;
}

/// Their watchdogs let the motors go by themselves.
RigPromises of_controllers() {
    RigPromises promises;
    promises.loss_s = 0.0;
    promises.place_m = 1e-4;
    promises.free_s = watchdog_s + 1e-3;
    promises.alone_s = promises.free_s;
    return promises;
}

RigPromises of_the_simulated_cartesian() {
    RigPromises promises = of_the_simulated_pantograph();
    promises.place_m = 5e-5;
    promises.keeps_way = true;
    return promises;
}

const std::array rows{
    RigRow{"UsbBoard", board_rig, of_the_board()},
    RigRow{"Inverse3", inverse3_rig, of_the_inverse3()},
    RigRow{"SimulatedPantograph", simulated_pantograph_rig, of_the_simulated_pantograph()},
    RigRow{"Moteus", moteus_rig, of_controllers()},
    RigRow{"Odrive", odrive_rig, of_controllers()},
    RigRow{"SimulatedCartesian", simulated_cartesian_rig, of_the_simulated_cartesian()},
};

}  // namespace

std::span<const RigRow> rig_rows() {
    return rows;
}

}  // namespace touchline
