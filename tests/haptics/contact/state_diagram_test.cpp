// The paper's state diagram (section 4) on every small world: three points, or two segments of two
// outlines, a point and a disc, with and without friction, under short sequences of handle
// positions. TOUCHLINE_EXHAUSTIVE=1 takes all sequences of three (tests/README.md).
#include "tests/haptics/collision/trials.h"
#include "tests/haptics/contact/small_worlds.h"
#include "tests/haptics/contact/step_rules.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int most_messages = 5;
constexpr int settling_steps = 16;
constexpr std::size_t most_way_points = 64;  // 256 walks would take at least as many
constexpr double last_digit_m = 1e-17;
constexpr double at_rest_m = 1e-14;

/// A test takes one in so many first, second and third handle positions.
struct Strides {
    std::size_t first, second, third;
};

/// Counts what was seen, so that a test that saw nothing does not pass.
struct Tally {
    std::size_t steps = 0;
    std::size_t carried = 0;
    std::array<std::array<std::size_t, 3>, 3> transitions{};
    std::size_t in_two_contacts = 0;
    std::size_t round_a_vertex = 0;
    std::size_t longest_path = 0;
    double least_width = 1.0;  // kept by a disc that had room at the start, in radii
    std::size_t faults = 0;
    std::size_t restless = 0;  // sequences that leave the proxy on its way under a handle at rest
    std::uint64_t digest = 0;
};

/// One world and one proxy.
class Trial {
  public:
    Trial(const TactileMap& map, const ContactSettings& settings, double spacing_m, Tally& tally)
        : map_(map),
          settings_(settings),
          tally_(tally),
          scene_(scene_of(map, settings, spacing_m)),
          judge_(scene_.curves, 0.0, 4.0 * small_worlds::pitch_m) {}

    void run(const std::vector<Position>& handles, const Strides& strides, std::size_t k) {
        ContactMachine machine;
        machine.record_path(&path_);
        for (const Position first : handles) {
            if (++k % strides.first != 0) continue;
            machine.reset(scene_, first, 0.0);
            start_m_ = width_at(machine.proxy().centre);
            // Between two lines closer than a skin there is no place to start.
            if (start_m_ < 0.5 * contact_skin_m) continue;
            for (const Position second : handles) {
                if (++k % strides.second != 0) continue;
                ContactMachine once = machine;
                hand_ = {first, second};
                static_cast<void>(step(once, second));
                for (const Position third : handles) {
                    if (++k % strides.third != 0) continue;
                    ContactMachine twice = once;
                    hand_ = {first, second, third};
                    settle(twice, third);
                }
            }
        }
    }

  private:
    static Scene scene_of(const TactileMap& map, const ContactSettings& settings,
                          double spacing_m) {
        CurveOptions options;
        options.spacing_m = spacing_m;
        return build_scene(map, options, settings.radius_m).value();
    }

    ContactReport step(ContactMachine& machine, Position handle) {
        const ProxyState before = machine.proxy();
        const ContactReport report = machine.step(handle, 0.0, settings_, {});
        const ProxyState& after = machine.proxy();
        const char* rule = broken_rule(
            {scene_.curves, judge_, settings_, 0.0, handle, before, after, report, path_});
        if (rule != nullptr) fault(rule);
        judge_width(after.centre);
        if (path_.size() > most_way_points) fault("few way points lead through a small world");
        count(report, after);
        return report;
    }

    double width_at(Position centre) const {
        return judge_.distance_m(centre, std::max(2.0 * settings_.radius_m, contact_skin_m));
    }

    /// The proxy always keeps half a skin (touch.h). Rounding a vertex in chords of 15 degrees
    /// costs a disc that had room up to 1 % at another line, twice in these sequences.
    void judge_width(Position centre) {
        const double kept_m = width_at(centre);
        if (kept_m < std::min(0.5 * contact_skin_m, start_m_ - last_digit_m))
            fault("half a skin is kept");
        if (settings_.radius_m == 0.0 || start_m_ < settings_.radius_m) return;
        tally_.least_width = std::min(tally_.least_width, kept_m / settings_.radius_m);
        if (kept_m < 0.98 * settings_.radius_m) fault("a disc keeps its radius");
    }

    void count(const ContactReport& report, const ProxyState& proxy) {
        ++tally_.steps;
        tally_.carried += report.carried_m > 0.0 ? 1U : 0U;
        tally_.in_two_contacts += proxy.contact_count == 2 ? 1U : 0U;
        tally_.round_a_vertex += proxy.contact_count == 1 && proxy.contacts[0].is_round ? 1U : 0U;
        tally_.longest_path = std::max(tally_.longest_path, path_.size());
        for (int i = 1; i < report.transitions.size(); ++i) {
            const auto from = static_cast<std::size_t>(report.transitions[i - 1]);
            ++tally_.transitions[from][static_cast<std::size_t>(report.transitions[i])];
        }
        for (const double x : {report.p_WP.x, report.p_WP.y, report.force.x, report.parameter}) {
            tally_.digest = 31 * tally_.digest + std::bit_cast<std::uint64_t>(x);
        }
    }

    /// Lets the proxy come to rest under a handle at rest.
    void settle(ContactMachine& machine, Position handle) {
        for (int i = 0; i < settling_steps; ++i) {
            const Position before = machine.proxy().centre;
            const ContactReport report = step(machine, handle);
            if (report.carried_m == 0.0 && norm(report.p_WP - before) <= at_rest_m) return;
        }
        ++tally_.restless;
    }

    void fault(const char* rule) {
        if (++tally_.faults > most_messages) return;
        std::ostringstream text;
        text.precision(std::numeric_limits<double>::max_digits10);
        text << rule << ": radius " << settings_.radius_m << ", friction " << settings_.friction;
        for (const Outline& outline : map_.outlines) {
            text << (outline.is_closed ? "; closed" : "; open");
            for (const Position p : outline.points) text << " (" << p.x << ", " << p.y << ")";
        }
        text << "; hand";
        for (const Position p : hand_) text << " (" << p.x << ", " << p.y << ")";
        ADD_FAILURE() << text.str();
    }

    const TactileMap& map_;
    ContactSettings settings_;
    Tally& tally_;
    Scene scene_;
    Judge judge_;
    std::vector<Position> path_;
    std::vector<Position> hand_;
    double start_m_ = 0.0;  // from the nearest line at the start
};

Tally tally_of(const std::vector<TactileMap>& worlds, const Strides& strides) {
    const auto handles = small_worlds::handles();
    Tally tally;
    std::size_t k = 0;
    for (const TactileMap& world : worlds) {
        for (const double radius : {0.0, 1e-3}) {
            for (const double friction : {0.0, 0.3}) {
                const ContactSettings settings{Mode::wall, 500.0, friction, radius, 0.003};
                // Every third trial splits edges into straight joints.
                const double spacing_m = ++k % 3 == 0 ? 0.5 * small_worlds::pitch_m : 1.0;
                Trial(world, settings, spacing_m, tally).run(handles, strides, k);
            }
        }
    }
    return tally;
}

Tally expect_the_diagram(const std::vector<TactileMap>& worlds, const Strides& strides) {
    const Tally tally = tally_of(worlds, strides);
    const auto& seen = tally.transitions;
    std::cout << "  " << worlds.size() << " worlds, " << tally.steps << " steps, " << tally.carried
              << " carried; 0>1 " << seen[0][1] << ", 1>0 " << seen[1][0] << ", 1>2 " << seen[1][2]
              << ", 2>1 " << seen[2][1] << "; in two contacts " << tally.in_two_contacts
              << ", round a vertex " << tally.round_a_vertex << "; longest path "
              << tally.longest_path << ", least width " << tally.least_width << ", restless "
              << tally.restless << "\n";
    testing::Test::RecordProperty("states", static_cast<int>(worlds.size()));
    testing::Test::RecordProperty("steps", std::to_string(tally.steps));
    EXPECT_EQ(tally.faults, 0U);
    for (const auto& [from, to] : {std::array<std::size_t, 2>{0, 1}, {1, 0}, {1, 2}, {2, 1}}) {
        EXPECT_GT(seen[from][to], tally.steps / 100) << from << ">" << to;
    }
    EXPECT_GT(tally.in_two_contacts, tally.steps / 100);
    EXPECT_GT(tally.round_a_vertex, tally.steps / 100);
    return tally;
}

TEST(StateDiagram, HoldsOnEveryPolylineOfThreePoints) {
    const std::size_t third = trials::count(19, 1);
    EXPECT_EQ(expect_the_diagram(small_worlds::polylines(), {1, 1, third}).restless, 0U);
}

TEST(StateDiagram, HoldsOnEveryPairOfSegments) {
    const Strides strides{trials::count(7, 1), trials::count(5, 1), trials::count(13, 1)};
    EXPECT_EQ(expect_the_diagram(small_worlds::pairs(), strides).restless, 0U);
}

TEST(StateDiagram, HoldsWhereTwoSegmentsNearlyMeet) {
    const Strides strides{trials::count(29, 3), trials::count(11, 1), trials::count(7, 3)};
    const Tally tally = expect_the_diagram(small_worlds::near_meetings(), strides);
    // Not fixed: round two ends that are 1 pm apart, less than the contact skin, a point may stay.
    EXPECT_LE(tally.restless, 1 + tally.steps / 100'000);
}

TEST(StateDiagram, IsWalkedTheSameWayBitForBit) {
    const Strides strides{7, 5, 11};
    const auto worlds = small_worlds::polylines();
    EXPECT_EQ(tally_of(worlds, strides).digest, tally_of(worlds, strides).digest);
}

}  // namespace
}  // namespace touchline
