// Ways to the screen where a test begins, in English, by the names that are said.
#pragma once

#include "tests/app/visit/fake_world.h"

#include <vector>

namespace touchline {

void to_choose(FakeHouse& house);

/// Goes to a picture of the gallery and feels it.
void to_picture(FakeHouse& house);

/// Goes to a picture of a stick with `count` files and feels it.
void to_stick_picture(FakeHouse& house, int count = 3);

/// Ends the visit by Finish and Yes, from any screen that lies over no other.
void finish(FakeHouse& house);

/// Whether the open screen has it.
[[nodiscard]] bool has_item(const FakeHouse& house, VisitItem item);

/// Returns every place a visitor can reach: a visit for every state that keys, pictures, time and
/// trouble lead to. Computed once.
const std::vector<Visit>& scenes_of_all_screens();

/// scenes_of_all_screens(), and the least number of presses from each to choose.
struct SceneGraph {
    std::vector<Visit> visits;
    std::vector<std::string> names;       // path, what is over it, what is felt
    std::vector<int> presses_to_choose;   // -1: never
    std::vector<std::string> unanswered;  // keys that caused neither speech nor cue
    std::vector<std::string> lost;        // scenes where Back lost the picture
    std::size_t steps = 0;                // keys and events tried
};

const SceneGraph& scene_graph();

}  // namespace touchline
