#include "tests/audio-cues/hand/hand_sound.h"

#include "app/force/servo/scene_order.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/cues/guidance.h"
#include "haptics/device/simulated/simulated_pantograph.h"
#include "haptics/servo/servo_step.h"
#include "tests/haptics/tick.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace touchline {
namespace {

constexpr double start_s = 0.5;
constexpr double no_line_m = std::numeric_limits<double>::infinity();

double distance_to_segment(Position p, Position a, Position b) {
    const Position edge = b - a;
    const double length2 = dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
    return norm(p - (a + t * edge));
}

double distance_to(const TactileMap& map, Position p) {
    double nearest_m = no_line_m;
    for (const Outline& outline : map.outlines) {
        const auto& points = outline.points;
        for (std::size_t i = 1; i < points.size(); ++i) {
            nearest_m = std::min(nearest_m, distance_to_segment(p, points[i - 1], points[i]));
        }
        if (outline.is_closed) {
            nearest_m = std::min(nearest_m, distance_to_segment(p, points.back(), points.front()));
        }
    }
    return nearest_m;
}

std::vector<WaypointPath::Waypoint> timed(const std::vector<Position>& way, double speed_m_per_s) {
    std::vector<WaypointPath::Waypoint> points{{0.0, way.front()}, {start_s, way.front()}};
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double leg_s = std::max(norm(way[i] - way[i - 1]) / speed_m_per_s, tick_s);
        points.push_back({points.back().t_s + leg_s, way[i]});
    }
    return points;
}

}  // namespace

Result<HandRun> follow(const TactileMap& map, const std::vector<Position>& way,
                       double speed_m_per_s) {
    const DeviceProfile& profile = default_profile();
    TactileMap numbered = map;
    numbered.version = 1;
    auto scene = build_scene(numbered, felt_order(profile));
    if (!scene) return tl::unexpected(scene.error());
    const auto points = timed(way, speed_m_per_s);
    SimulatedPantograph device(profile, SimulationOptions{},
                               std::make_shared<WaypointPath>(points));
    ServoStep servo(profile, tick_s);
    ServoCommands commands;
    commands.contact.mode = Mode::ridge;
    HandRun run;
    const auto ticks = static_cast<int>(points.back().t_s / tick_s);
    for (int i = 0; i < ticks; ++i) {
        const double now_s = tick_s * i;
        const StepInput input{now_s, 0, device.read(now_s), commands, &*scene};
        (void)device.write(servo.step(input));
        run.events.insert(run.events.end(), servo.events().begin(), servo.events().end());
        run.handle.push_back(servo.report().hand.p_WH);
        run.distance_m.push_back(distance_to(map, run.handle.back()));
    }
    return run;
}

std::vector<StereoFrame> sound_of(const HandRun& run, CueAmount amount) {
    Mixer mixer;
    CueState state;
    state.amount = amount;
    const ContinuousChoice choice{amount, false, std::nullopt};
    std::vector<StereoFrame> sound;
    std::size_t next_event = 0;
    for (std::size_t tick = 0; tick < run.handle.size() + 500; ++tick) {
        const FrameTime now = static_cast<FrameTime>(tick) * frame_rate_Hz / 1000;
        const double now_s = tick_s * static_cast<double>(tick);
        for (; next_event < run.events.size() && run.events[next_event].time_s <= now_s;
             ++next_event) {
            const CueStep step = cue_step(state, run.events[next_event]);
            state = step.state;
            if (step.cue) mixer.send(sound_of(*step.cue, now));
        }
        if (tick % 16 == 0) {  // as often as a frame of the screen
            const bool is_there = tick < run.handle.size();
            const Position hand = is_there ? run.handle[tick] : Position{};
            const double distance_m = is_there ? run.distance_m[tick] : no_line_m;
            mixer.send({now, SetContinuous{continuous_tone(choice, hand, distance_m, state.area)}});
        }
        std::array<StereoFrame, frame_rate_Hz / 1000> frames;
        mixer.render(frames);
        sound.insert(sound.end(), frames.begin(), frames.end());
    }
    return sound;
}

}  // namespace touchline
