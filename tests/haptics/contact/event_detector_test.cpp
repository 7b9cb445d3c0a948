// What the detector tells of the hand: everything that happens, and no flood of it.
#include "haptics/contact/event_detector.h"

#include "tests/haptics/contact/hold_rig.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using enum ContactEventKind;
using scenes::map_of;
using scenes::outline;

/// A machine and the events that it causes.
class Told {
  public:
    Told(const TactileMap& map, Mode mode, Position start, const CurveOptions& options = {})
        : scene_(build_scene(map, options, 0.0).value()), hand_(start) {
        settings_.mode = mode;
        machine_.reset(scene_, start, 0.0);
        run(1);
    }

    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) feel(hand_);
    }

    void feel(Position p) {
        hand_ = p;
        const ContactReport report = machine_.step(p, level, settings_, {});
        const EventInput input{time_s_, p, settings_.mode, report, machine_.rendered_level(),
                               &scene_};
        const TickEvents found = detector_.step(input);
        events_.insert(events_.end(), found.all().begin(), found.all().end());
        time_s_ += tick_s;
    }

    /// Moves the hand at 50 mm/s.
    void go(Position to) {
        const Position from = hand_;
        const int ticks = static_cast<int>(std::ceil(norm(to - from) / 5e-5));
        for (int i = 1; i <= ticks; ++i) {
            feel(from + static_cast<double>(i) / ticks * (to - from));
        }
    }

    /// Returns the events in order and forgets them.
    std::vector<ContactEventKind> kinds() {
        std::vector<ContactEventKind> found;
        for (const ContactEvent& event : events_) found.push_back(event.kind);
        events_.clear();
        return found;
    }

    [[nodiscard]] const std::vector<ContactEvent>& events() const { return events_; }

    ContactSettings& settings() { return settings_; }

    double level = 0.0;

  private:
    Scene scene_;
    Position hand_;
    ContactSettings settings_;
    ContactMachine machine_;
    EventDetector detector_;
    double time_s_ = 0.0;
    std::vector<ContactEvent> events_;
};

using Kinds = std::vector<ContactEventKind>;

TactileMap one_line() {
    return map_of({outline({{-0.03, 0.0}, {0.03, 0.0}}, false)});
}

TEST(TickEvents, HoldsOneOfEveryKind) {
    TickEvents events;
    for (std::size_t kind = 0; kind < contact_event_count; ++kind) {
        ContactEvent event;
        event.kind = static_cast<ContactEventKind>(kind);
        events.add(event);
    }
    ASSERT_EQ(events.all().size(), contact_event_count);
    EXPECT_EQ(events.all().back().kind, popped_through);
}

TEST(EventDetector, TellsOfContactInEveryMode) {
    for (const Mode mode : all_modes) {
        Told told(one_line(), mode, {0.0, 0.01});
        told.go({0.0, mode == Mode::wall ? -0.001 : 0.001});
        told.run(50);
        EXPECT_EQ(told.kinds(), Kinds{contact_made}) << static_cast<int>(mode);
        told.run(100);
        told.go({0.0, 0.01});
        told.run(50);
        EXPECT_EQ(told.kinds(), Kinds{contact_lost}) << static_cast<int>(mode);
    }
}

TEST(EventDetector, AWallIsNeverCrossedAndAGrooveIs) {
    for (const Mode mode : all_modes) {
        Told told(one_line(), mode, {0.0, 0.002});
        told.run(100);
        told.go({0.0, -0.002});
        told.run(50);
        const Kinds expected =
            mode == Mode::wall ? Kinds{contact_made} : Kinds{contact_made, line_crossed};
        EXPECT_EQ(told.kinds(), expected) << static_cast<int>(mode);
    }
}

TEST(EventDetector, ALineThatTakesOverIsCrossedAndAnotherOutline) {
    const TactileMap map = map_of({outline({{-0.03, 0.001}, {0.03, 0.001}}, false),
                                   outline({{-0.03, -0.001}, {0.03, -0.001}}, false)});
    Told told(map, Mode::groove, {0.0, 0.0008});
    told.run(100);
    EXPECT_EQ(told.kinds(), Kinds{contact_made});
    told.go({0.0, -0.0008});
    told.run(100);
    ASSERT_EQ(told.events().size(), 2U);
    EXPECT_EQ(told.events()[0].kind, line_crossed);
    EXPECT_EQ(told.events()[1].kind, outline_changed);
    EXPECT_EQ(told.events()[1].outline, 1);
    EXPECT_NEAR(told.events()[1].place_W.y, -0.001, 1e-9);
    EXPECT_NEAR(told.events()[1].parameter, 0.5, 0.01);
}

TEST(EventDetector, VerticesAndEndsAreToldOnceEachWay) {
    const TactileMap corner = map_of({outline({{-0.02, 0.0}, {0.0, 0.0}, {0.0, 0.02}}, false)});
    for (const Mode mode : {Mode::wall, Mode::groove}) {
        const double off_m = mode == Mode::wall ? 0.001 : 0.0;  // presses from inside
        Told told(corner, mode, {-0.01, 0.001});
        told.run(100);
        told.go({-0.01, -off_m});
        told.run(100);
        told.kinds();
        told.go({off_m, -off_m});
        told.go({off_m, 0.012});
        EXPECT_EQ(told.kinds(), Kinds{vertex_passed}) << static_cast<int>(mode);
        told.go({off_m, -off_m});
        told.go({-0.012, -off_m});
        EXPECT_EQ(told.kinds(), Kinds{vertex_passed}) << static_cast<int>(mode);
        told.go({-0.0215, -off_m});
        const Kinds found = told.kinds();
        EXPECT_EQ(std::count(found.begin(), found.end(), end_reached), 1);
        EXPECT_EQ(std::count(found.begin(), found.end(), line_crossed), 0);
    }
}

/// A drop: round, with one tip at the right.
TactileMap drop() {
    std::vector<Position> points{{0.03, 0.0}};
    for (int i = 1; i < 64; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 64.0;
        points.push_back({0.03 * std::cos(turn), 0.03 * std::sin(turn) * std::sin(0.5 * turn)});
    }
    return map_of({outline(std::move(points), true)});
}

int told_on_the_way(const TactileMap& map, const CurveOptions& options,
                    const std::vector<Position>& way, ContactEventKind kind) {
    Told told(map, Mode::groove, way.front(), options);
    told.run(100);
    told.kinds();
    for (const Position p : way) told.go(p);
    const Kinds found = told.kinds();
    return static_cast<int>(std::count(found.begin(), found.end(), kind));
}

TEST(EventDetector, TheOnlyCornerOfALoopIsToldAndTheOtherPointsOfItAreNot) {
    const TactileMap map = drop();
    std::vector<Position> round = map.outlines[0].points;
    std::rotate(round.begin(), round.begin() + 20, round.end());
    std::vector<Position> half(round.begin(), round.begin() + 30);
    EXPECT_EQ(told_on_the_way(map, {}, round, vertex_passed), 1);
    std::reverse(round.begin(), round.end());
    EXPECT_EQ(told_on_the_way(map, {}, round, vertex_passed), 1);
    EXPECT_EQ(told_on_the_way(map, {}, half, vertex_passed), 0);
}

TEST(EventDetector, APinThatIsNoCornerIsNotTold) {
    CurveOptions pinned;
    pinned.pins = {{0, {0.0, 0.0}}};
    const std::vector<Position> way{{-0.02, 0.0}, {0.02, 0.0}};
    const TactileMap line = map_of({outline({{-0.03, 0.0}, {0.0, 0.0}, {0.03, 0.0}}, false)});
    EXPECT_EQ(build_scene(line, pinned, 0.0)->curves.pieces().size(), 2U);
    EXPECT_EQ(told_on_the_way(line, pinned, way, vertex_passed), 0);
}

TEST(EventDetector, TellsOfTheEdgeOfTheArea) {
    Told told(one_line(), Mode::wall, {0.05, 0.03});
    told.go({0.0, 0.045});
    told.run(100);
    EXPECT_EQ(told.kinds(), Kinds{area_left});
    told.go({0.0, 0.03});
    told.run(100);
    EXPECT_EQ(told.kinds(), Kinds{area_entered});
}

TEST(EventDetector, TellsOfWholeLevelsOnly) {
    const TactileMap ring = map_of({scenes::circle(0.02, 256)});
    Told told(ring, Mode::groove, {0.02, 0.0});
    told.run(200);
    told.kinds();
    told.level = 2.0;
    told.run(500);
    ASSERT_EQ(told.events().size(), 1U);
    EXPECT_EQ(told.events()[0].kind, level_changed);
    EXPECT_EQ(told.events()[0].level, 2.0);
    told.kinds();
    told.level = 1.5;
    told.run(500);
    EXPECT_EQ(told.kinds(), Kinds{});
}

TEST(EventDetector, TellsOfAWallThatGaveWay) {
    Told told(one_line(), Mode::wall, {0.0, 0.003});
    told.settings().pop_through_N = 1.5;
    told.go({0.0, -0.004});
    told.run(600);
    EXPECT_EQ(told.kinds(), (Kinds{contact_made, popped_through, contact_lost}));
}

/// Returns the most events of one kind within a second.
int most_in_a_second(const std::vector<ContactEvent>& events) {
    int most = 0;
    for (const ContactEvent& first : events) {
        const auto is_near = [&](const ContactEvent& event) {
            return event.kind == first.kind && event.time_s >= first.time_s &&
                   event.time_s < first.time_s + 1.0;
        };
        most =
            std::max(most, static_cast<int>(std::count_if(events.begin(), events.end(), is_near)));
    }
    return most;
}

TEST(EventDetector, AHandAtRestWithNoiseMakesNoStorm) {
    const TactileMap map = map_of({outline({{-0.02, 0.0}, {0.0, 0.0}, {0.0, 0.02}}, false),
                                   outline({{0.0, 0.0}, {0.02, -0.01}}, false)});
    const std::array<Position, 6> places{{{0.0, 0.0},       // on the vertex, also another line's
                                          {-0.01, 0.0},     // on a line
                                          {-0.02, 0.0},     // on its end
                                          {-0.01, 0.003},   // at the edge of the capture
                                          {-0.01, 3e-4},    // where a side begins to count
                                          {0.058, 0.03}}};  // at the edge of the area
    std::mt19937 random(1);
    for (const double noise_m : {1e-5, 5e-5, 1e-4}) {
        std::normal_distribution<double> noise(0.0, noise_m);
        for (const Mode mode : all_modes) {
            for (const Position place : places) {
                Told told(map, mode, place);
                for (int i = 0; i < 5000; ++i) {
                    told.feel(place + Position{noise(random), noise(random)});
                }
                EXPECT_LE(most_in_a_second(told.events()), 5)
                    << static_cast<int>(mode) << " " << place.x << " " << place.y;
                EXPECT_LE(told.events().size(), 25U)
                    << static_cast<int>(mode) << " " << place.x << " " << place.y;
            }
        }
    }
}

TEST(EventDetector, TheWildestHandMakesNoMoreThanTwentyOfAKindASecond) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<ContactEventKind> seen;
    for (const Mode mode : all_modes) {
        Told told(scenes::random_map(4, 20), mode, {0.0, 0.0});
        Position aim;
        Position at;
        for (int i = 0; i < 20000; ++i) {
            if (i % 100 == 0) aim = {0.07 * unit(random), 0.05 * unit(random)};
            if (i % 300 == 0) told.level = std::floor(1.5 + 1.5 * unit(random));
            at += 0.02 * (aim - at);
            told.feel(at);
        }
        for (const ContactEvent& event : told.events()) seen.push_back(event.kind);
        EXPECT_LE(most_in_a_second(told.events()), 20);
    }
    for (const ContactEventKind kind :
         {contact_made, contact_lost, vertex_passed, line_crossed, end_reached, level_changed,
          outline_changed, area_entered, area_left}) {
        EXPECT_TRUE(std::find(seen.begin(), seen.end(), kind) != seen.end())
            << static_cast<int>(kind);
    }
}

}  // namespace
}  // namespace touchline
