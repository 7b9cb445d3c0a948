#include "haptics/servo/replay.h"

#include <map>
#include <string>

namespace touchline {
namespace {

using SceneOf = std::function<Result<std::shared_ptr<const Scene>>(std::uint64_t version)>;

/// Every scene that the ticks name, by version; 0 means no scene.
using Scenes = std::map<std::uint64_t, std::shared_ptr<const Scene>>;

Result<Scenes> scenes_of(const Recording& recording, const SceneOf& scene_of) {
    Scenes scenes{{0, nullptr}};
    const auto add = [&](std::uint64_t version) -> Result<void> {
        if (scenes.contains(version)) return {};
        auto scene = scene_of(version);
        if (!scene) return tl::unexpected(scene.error());
        scenes.emplace(version, std::move(*scene));
        return {};
    };
    if (auto added = add(recording.start_version); !added) return tl::unexpected(added.error());
    for (std::size_t i = recording.start_tick; i < recording.ticks.size(); ++i) {
        auto added = add(recording.ticks[i].wanted_version);
        if (!added) return tl::unexpected(added.error());
    }
    return scenes;
}

}  // namespace

Result<Replay> run_again(const Recording& recording, const SceneOf& scene_of) {
    if (recording.start.empty()) {
        return failure(
            "the recording cannot be run again: a visitor's picture was felt, of which only "
            "inputs, outputs and a number are kept, or a shape was in the hand all the time");
    }
    const auto profile = find_profile(recording.profile);
    if (!profile) return tl::unexpected(profile.error());
    const auto scenes = scenes_of(recording, scene_of);
    if (!scenes) return tl::unexpected(scenes.error());
    auto step = ServoStep::from_memory(recording.start, scenes->at(recording.start_version).get(),
                                       *profile);
    if (!step) {
        return failure("the recording cannot be run again: another build of touchline wrote it");
    }
    ShapeInHand hand;
    step->lend(&hand);
    Replay replay;
    replay.first = recording.start_tick;
    for (std::size_t i = recording.start_tick; i < recording.ticks.size(); ++i) {
        const TickRecord& told = recording.ticks[i];
        StepInput input = told.input;
        input.scene = scenes->at(told.wanted_version).get();
        if (told.is_fading_out) step->fade_out();
        const JointTorques torques = step->step(input);
        replay.ticks.push_back(record_of(input, *step, torques, told.is_refused));
        if (told.is_refused) step->lose_device();
        if (!replay.differs_at && !came_out_same(replay.ticks.back(), told)) {
            replay.differs_at = i;
        }
    }
    return replay;
}

}  // namespace touchline
