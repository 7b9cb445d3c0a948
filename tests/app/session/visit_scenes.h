// Ways to where a test begins. English, by the names that are said.
#pragma once

#include "tests/app/session/fake_world.h"

#include <vector>

namespace touchline {

void to_choose(FakeHouse& house);

/// A picture of the gallery, felt.
void to_picture(FakeHouse& house);

/// One of a stick of `count`, felt.
void to_stick_picture(FakeHouse& house, int count = 3);

/// From any screen but those over others: Finish, yes.
void finish(FakeHouse& house);

/// Where anybody can get: a visit for every state that keys, pictures, time and trouble lead to.
/// Found once.
const std::vector<Visit>& scenes_of_all_screens();

/// Of scenes_of_all_screens(), and how many presses each is from choose at least.
struct SceneGraph {
    std::vector<Visit> visits;
    std::vector<std::string> names;       // path, what is over it, what is felt
    std::vector<int> presses_to_choose;   // -1: never
    std::vector<std::string> unanswered;  // keys that gave neither speech nor cue
    std::vector<std::string> lost;        // Back lost the picture
    std::size_t steps = 0;                // keys and events that were tried
};

const SceneGraph& scene_graph();

}  // namespace touchline
