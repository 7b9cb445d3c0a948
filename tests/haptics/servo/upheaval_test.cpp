// Everything that may change under a hand changes, at random and at once, through the whole servo
// step: level, range, stiffness, friction, mode and picture. It never lets the hand through.
#include "haptics/servo/servo_step.h"
#include "tests/haptics/collision/crossings.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/servo/rigs.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double ring_m = 0.03;
constexpr Position far_off{0.5, 0.313};

struct Changes {
    int ticks = 0;
    int in_wall_contact = 0;
    int levels = 0;
    int modes = 0;
    int maps = 0;
    int sides_flipped = 0;
    int refused = 0;       // by a fault, or because no hand was seen
    double worst_N = 0.0;  // step of the commanded force
};

bool is_inside(const Scene& scene, const HandState& hand) {
    return crossings(scene.tree, scene.curves, hand.p_WP, far_off, hand.level) % 2 != 0;
}

class Upheaval {
  public:
    Upheaval(const std::vector<Scene>& scenes, double radius_m, unsigned seed)
        : scenes_(scenes), random_(seed) {
        commands_.contact.radius_m = radius_m;
        commands_.contact.mode = Mode::wall;
    }

    Changes run(int ticks) {
        const DeviceProfile& profile = default_profile();
        ServoStep step(profile, tick_s);
        Changes changes;
        HandState last;
        bool was_inside = false;
        double angle = 0.0;
        for (int i = 0; i < ticks; ++i) {
            change();
            angle += speed_m_per_s_ * tick_s / ring_m;
            // Free and far off for the first half second, so that force comes on.
            const double far_m = 0.008 * std::clamp(0.01 * (900.0 - i), 0.0, 1.0);
            const double depth_m =
                far_m + 0.0045 * std::sin(2.0 * std::numbers::pi * 0.7 * tick_s * i);
            const Position handle = (ring_m + depth_m) * Position{std::cos(angle), std::sin(angle)};
            const StepInput input{tick_s * i, 0, reading_at(profile, handle), commands_, wanted_};
            (void)step.step(input);
            const HandState& hand = step.report().hand;
            const bool is_map_new = hand.map_version != last.map_version;
            const bool is_mode_new = hand.mode != last.mode;
            changes.maps += is_map_new ? 1 : 0;
            changes.modes += is_mode_new ? 1 : 0;
            changes.levels += hand.level != last.level ? 1 : 0;
            const bool is_walled = step.scene() != nullptr && hand.mode == Mode::wall;
            if (is_walled) {
                const bool is_now = is_inside(*step.scene(), hand);
                const bool is_kept = !is_map_new && !is_mode_new && i > 0;
                changes.sides_flipped += is_kept && is_now != was_inside ? 1 : 0;
                changes.in_wall_contact += hand.state != ContactState::free ? 1 : 0;
                was_inside = is_now;
            }
            changes.worst_N = std::max(changes.worst_N, norm(hand.force - last.force));
            last = hand;
            ++changes.ticks;
            const ForceStatus& force = step.report().force;
            changes.refused +=
                force.state == ForceState::fault || force.limit == Limit::hand ? 1 : 0;
        }
        return changes;
    }

  private:
    [[nodiscard]] double unit() {
        return std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    }

    [[nodiscard]] bool is_due(double share) { return unit() < share; }

    void change() {
        if (is_due(0.02)) commands_.is_level_auto = is_due(0.5);
        if (is_due(0.05)) commands_.level = is_due(0.5) ? 8.0 * unit() : std::floor(8.0 * unit());
        if (is_due(0.01)) commands_.finest_level = std::floor(4.0 * unit());
        if (is_due(0.01)) commands_.coarsest_level = commands_.finest_level + 5.0 * unit();
        if (is_due(0.01)) commands_.contact.stiffness_N_per_m = 200.0 + 500.0 * unit();
        if (is_due(0.005)) commands_.contact.friction = is_due(0.5) ? 0.0 : 0.3 * unit();
        if (is_due(0.003)) {
            const bool is_other = is_due(0.5);
            commands_.contact.mode =
                is_other ? static_cast<Mode>(1 + static_cast<int>(3.0 * unit()) % 3) : Mode::wall;
        }
        if (is_due(0.001) || wanted_ == nullptr) {
            wanted_ = &scenes_[static_cast<std::size_t>(unit() * 0.999 *
                                                        static_cast<double>(scenes_.size()))];
        }
        if (is_due(0.01)) speed_m_per_s_ = 0.3 * (unit() - 0.5);
    }

    const std::vector<Scene>& scenes_;
    std::mt19937 random_;
    ServoCommands commands_;
    const Scene* wanted_ = nullptr;
    double speed_m_per_s_ = 0.1;
};

TEST(Upheaval, NeverLetsTheHandThroughWhateverChanges) {
    Changes all;
    for (unsigned seed = 0; seed < 10; ++seed) {
        const double radius_m = seed % 2 == 0 ? 0.0 : 1.4e-3;
        std::vector<Scene> scenes;
        for (unsigned k = 0; k < 3; ++k) {
            TactileMap map = scenes::rough_ring(3 * seed + k, 1e-4 * k);
            map.version = k + 1;
            scenes.push_back(build_scene(map, {}, radius_m).value());
        }
        const Changes changes = Upheaval(scenes, radius_m, seed).run(50000);
        EXPECT_EQ(changes.sides_flipped, 0) << seed;
        all.ticks += changes.ticks;
        all.refused += changes.refused;
        all.in_wall_contact += changes.in_wall_contact;
        all.levels += changes.levels;
        all.modes += changes.modes;
        all.maps += changes.maps;
        all.worst_N = std::max(all.worst_N, changes.worst_N);
    }
    std::cout << "  " << all.ticks << " ticks, " << all.in_wall_contact
              << " in contact with a wall, " << all.levels << " changes of level, " << all.modes
              << " of mode, " << all.maps << " of the picture; largest step of the force "
              << all.worst_N << " N\n";
    EXPECT_LE(all.worst_N, 1500.0 * tick_s + 1e-12);  // rough lines jolt, but within the slew limit
    EXPECT_EQ(all.refused, 0);
    EXPECT_GT(all.in_wall_contact, 50000);
    EXPECT_GT(all.levels, 50000);
    EXPECT_GT(all.modes, 500);
    EXPECT_GT(all.maps, 200);
}

}  // namespace
}  // namespace touchline
