// A servo step without a device.
#pragma once

#include "haptics/servo/servo_step.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <memory>
#include <optional>

#include <gtest/gtest.h>

namespace touchline {

/// A servo step whose handle and commands the test sets, one virtual millisecond a tick.
struct Bench {
    const DeviceProfile profile;
    std::unique_ptr<ServoStep> step = std::make_unique<ServoStep>(profile, tick_s);
    StepInput input;
    std::optional<double> handle_rad;  // if the handle turns
    DeviceCommand told;

    explicit Bench(const DeviceProfile& of = default_profile()) : profile(of) {
        place({0.0, 0.01});
    }

    void place(Position p_W) { input.reading = reading_at(profile, p_W); }

    const HandState& run(int ticks) {
        for (int i = 0; i < ticks; ++i) {
            if (input.reading) input.reading->handle_rad = handle_rad;
            told = step->step(input);
            input.now_s += tick_s;
        }
        return hand();
    }

    /// Moves in small steps, as a hand does.
    void drag(Position from, Position to) {
        for (int i = 1; i <= 50; ++i) {
            place(from + i / 50.0 * (to - from));
            run(1);
        }
    }

    [[nodiscard]] const HandState& hand() const { return step->report().hand; }

    [[nodiscard]] const ForceStatus& force() const { return step->report().force; }
};

/// Returns a bench with live force, in free space above the line y = 0.
inline Bench bench_above_a_line(const std::shared_ptr<const Scene>& scene) {
    Bench bench;
    bench.input.scene = scene.get();
    bench.run(800);
    EXPECT_EQ(bench.force().state, ForceState::live);
    return bench;
}

}  // namespace touchline
