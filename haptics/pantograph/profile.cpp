#include "haptics/pantograph/profile.h"

#include "config/types/angle.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace touchline {
namespace {

constexpr JointAngles joints_at(double joint_1_deg, double joint_2_deg) {
    return {radians(joint_1_deg), radians(joint_2_deg)};
}

// The M0 board of every 2diy resolves half of the counts that its set-up command gives.
constexpr double m0_told_per_count = 2.0;

constexpr JointAngles m0_counts(double joint_1, double joint_2) {
    return {joint_1 / m0_told_per_count, joint_2 / m0_told_per_count};
}

constexpr Geometry gen3_links{0.070, 0.090, 0.038};
constexpr Geometry gen2_links{0.070, 0.090, 0.0};
constexpr Geometry haplet_links{0.050, 0.070, 0.020};
constexpr Geometry mk2_links{0.063, 0.075, 0.025};  // with joint 1 the paper's joint 5

// Mechanics: the middle of the ranges that users of the devices report or estimate.
constexpr MechanicsProfile plastic_arms{0.07, 0.2, 0.10, 6e-4};
constexpr MechanicsProfile metal_arms{0.08, 0.3, 0.15, 6e-4};
constexpr MechanicsProfile small_arms{0.05, 0.2, 0.10, 6e-4};
constexpr MechanicsProfile direct_drive{0.035, 0.05, 0.03, 1e-4};

// Plugged in as in the makers' own programs. The M0 is told twice the counts that it resolves.
constexpr JointWiring port_1_cw{1, Turn::clockwise}, port_1_ccw{1, Turn::counter_clockwise};
constexpr JointWiring port_2_cw{2, Turn::clockwise}, port_2_ccw{2, Turn::counter_clockwise};
constexpr BoardWiring gen3_wiring{port_2_ccw, port_1_ccw, m0_told_per_count};
constexpr BoardWiring gen2_wiring{port_2_ccw, port_1_cw, m0_told_per_count};
constexpr BoardWiring gen2_alike_wiring{port_2_ccw, port_1_ccw, m0_told_per_count};
constexpr BoardWiring haplet_wiring{port_1_cw, port_2_cw, 1.0};
constexpr BoardWiring mk2_wiring{port_1_ccw, port_2_ccw, 1.0};  // a custom board

// The two ends of a gen 3's reach are the home poses of its two generations. No other stop is
// published, so the others are checked with both arms stretched towards the person.
constexpr JointAngles gen3_retracted = joints_at(168.0, 12.0);
constexpr JointAngles gen3_extended = joints_at(97.23, 82.77);
constexpr CheckStop gen2_stretched{joints_at(90.0, 90.0), StopPlace::towards};
constexpr CheckStop haplet_stretched{joints_at(85.2198, 94.7802), StopPlace::towards};
constexpr CheckStop mk2_stretched{joints_at(84.8030, 95.1970), StopPlace::towards};

// Not sold by anyone: the arms of a gen 3.1 on a board with four ports, which resolves every count
// it is told, and a third motor of the same make straight at the handle.
constexpr BoardWiring turning_wiring{port_2_ccw, port_1_ccw, 1.0};
constexpr TurningHandle turning_handle{2048.0, 0.1, Turn::counter_clockwise, 2e-5, 2e-4, 1e-3};

constexpr DeviceProfile gen31{"2diy-gen3.1",
                              gen3_links,
                              m0_counts(4880.0, 4880.0),
                              0.123,
                              gen3_retracted,
                              Area{0.116, 0.084},
                              Position{0.019, 0.094},
                              3.0,
                              100.0,
                              plastic_arms,
                              gen3_wiring,
                              StopPlace::away,
                              CheckStop{gen3_extended, StopPlace::towards},
                              std::nullopt,
                              4096.0 / m0_told_per_count};

constexpr DeviceProfile gen2{"2diy-gen2",
                             gen2_links,
                             m0_counts(10752.0, 10752.0),
                             0.123,
                             joints_at(241.0, -61.0),
                             Area{0.144, 0.108},
                             Position{0.0, 0.076},
                             3.0,
                             100.0,
                             metal_arms,
                             gen2_wiring,
                             StopPlace::away,
                             gen2_stretched,
                             std::nullopt};

/// For units that are stopped elsewhere, as users' programs assume.
constexpr DeviceProfile stopped_at(DeviceProfile profile, std::string_view name, JointAngles home) {
    profile.name = name;
    profile.home = home;
    return profile;
}

/// As in one of the maker's programs.
constexpr DeviceProfile gen2_of_240() {
    DeviceProfile profile = stopped_at(gen2, "2diy-gen2-240", joints_at(240.0, -60.0));
    profile.counts_per_turn = m0_counts(10978.0, 10978.0);
    profile.wiring = gen2_alike_wiring;
    return profile;
}

// Areas: the largest 4:3 box in which the Jacobian's condition stays below 3. Force: up to 3 N,
// which the motors give in their best direction (2.8 N: mk2).
constexpr std::array profiles{
    gen31,
    stopped_at(gen31, "2diy-gen3.1-172", joints_at(172.0, 8.0)),
    stopped_at(gen31, "2diy-gen3.1-180", joints_at(180.0, 0.0)),
    DeviceProfile{
        "2diy-gen3", gen3_links, m0_counts(2048.0 * 2.5 * 1.0194 * 1.0154, 2048.0 * 2.5 * 1.0194),
        0.123, gen3_extended, Area{0.116, 0.084}, Position{0.019, 0.094}, 3.0, 100.0, plastic_arms,
        gen3_wiring, StopPlace::towards, CheckStop{gen3_retracted, StopPlace::away}, std::nullopt},
    gen2,
    gen2_of_240(),
    DeviceProfile{"haplet", haplet_links, JointAngles{13824.0, 13824.0}, 0.123,
                  joints_at(180.0, 0.0), Area{0.104, 0.076}, Position{0.010, 0.060}, 3.0, 100.0,
                  small_arms, haplet_wiring, StopPlace::sideways, haplet_stretched, std::nullopt},
    // No home pose is published, so this is the symmetric one near the centre of the area.
    DeviceProfile{"mk2", mk2_links, JointAngles{65536.0, 65536.0}, 0.1, joints_at(150.0, 30.0),
                  Area{0.096, 0.072}, Position{0.0125, 0.084}, 2.8, 400.0, direct_drive, mk2_wiring,
                  StopPlace::sideways, mk2_stretched, std::nullopt},
    DeviceProfile{"gen3.1-turning", gen3_links, JointAngles{4880.0, 4880.0}, 0.123, gen3_retracted,
                  Area{0.116, 0.084}, Position{0.019, 0.094}, 3.0, 100.0, plastic_arms,
                  turning_wiring, StopPlace::away, CheckStop{gen3_extended, StopPlace::towards},
                  turning_handle},
};

// Of its motors it is asked no more than the mk2's give; encoders of 14 bits. Mechanics: the rotors
// of such motors are heavier.
constexpr DeviceProfile open_arms{"open-five-bar",
                                  mk2_links,
                                  JointAngles{16384.0, 16384.0},
                                  0.1,
                                  joints_at(150.0, 30.0),
                                  Area{0.096, 0.072},
                                  Position{0.0125, 0.084},
                                  2.8,
                                  200.0,
                                  MechanicsProfile{0.07, 0.1, 0.05, 1e-3},
                                  mk2_wiring,
                                  StopPlace::sideways,
                                  mk2_stretched,
                                  std::nullopt};

constexpr DeviceProfile of_three_axes(std::string_view name, const Area& area, Position centre,
                                      const MechanicsProfile& mechanics,
                                      const CartesianDevice& device) {
    DeviceProfile profile;
    profile.name = name;
    profile.area = area;
    profile.centre = centre;
    profile.force_limit_N = 3.0;
    profile.mechanics = mechanics;
    profile.cartesian = device;
    return profile;
}

// A handle of the inverse3's mass that is let go at any height comes down slower than what the
// chain brakes. Its size leaves room for the plane's force below the limit.
constexpr PlaneSpring plane_spring{400.0, 2.0, 1.5, 0.004, 0.010, 0.020, 0.030};

// Not sold by anyone. Mechanics: between those of the five-bars and what a device with three axes
// and gears may have.
constexpr DeviceProfile made_up_cartesian = of_three_axes(
    "cartesian", Area{0.116, 0.084}, Position{0.0, 0.15}, MechanicsProfile{0.10, 0.3, 0.10, 1e-3},
    CartesianDevice{2e-5, 1.8, plane_spring});

// The drawing area lies about the middle of the arm's reach, in which the maker's programs send the
// handle 0.10 m around; all its corners are nearer. The maker publishes no mechanics: estimates.
constexpr DeviceProfile inverse3 = of_three_axes(
    "inverse3", Area{0.160, 0.100}, Position{0.0, 0.12}, MechanicsProfile{0.15, 0.3, 0.10, 2e-3},
    CartesianDevice{5e-5, 1.5, plane_spring});

constexpr std::array cartesians{made_up_cartesian, inverse3};

}  // namespace

std::span<const DeviceProfile> device_profiles() {
    return profiles;
}

std::span<const DeviceProfile> cartesian_profiles() {
    return cartesians;
}

const DeviceProfile& open_five_bar() {
    return open_arms;
}

const DeviceProfile& default_profile() {
    return profiles.front();
}

Result<DeviceProfile> find_profile(std::string_view name) {
    const auto* const found = std::ranges::find(profiles, name, &DeviceProfile::name);
    if (found != profiles.end()) return *found;
    std::string names;
    for (const DeviceProfile& p : profiles)
        names += (names.empty() ? "" : ", ") + std::string(p.name);
    return failure("no device profile is named '" + std::string(name) + "'; choose one of " +
                   names);
}

Result<DeviceProfile> find_device_profile(std::string_view name) {
    if (name == open_arms.name) return open_arms;
    const auto* const found = std::ranges::find(cartesians, name, &DeviceProfile::name);
    return found != cartesians.end() ? *found : find_profile(name);
}

DeviceProfile profile_or_default(std::string_view name) {
    return find_profile(name).value_or(default_profile());
}

JointAngles encoder_quantum(const DeviceProfile& profile) {
    return {2.0 * std::numbers::pi / profile.counts_per_turn.x,
            2.0 * std::numbers::pi / profile.counts_per_turn.y};
}

double encoder_quantum_rad(const TurningHandle& handle) {
    return 2.0 * std::numbers::pi / handle.counts_per_turn;
}

double encoder_step_m(const DeviceProfile& profile) {
    if (profile.cartesian) return profile.cartesian->step_m;
    const auto angles = inverse(profile.geometry, profile.centre);
    const auto pose = forward(profile.geometry, angles.value());
    return singular_values(pose.value().jacobian, encoder_quantum(profile)).largest;
}

}  // namespace touchline
