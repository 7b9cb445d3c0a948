#include "tests/app/screen/every_screen.h"

#include "app/operator/operator.h"
#include "app/visit/told_lines.h"
#include "app/visit/visit.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <string>

namespace touchline {
namespace {

std::size_t place_of(const Language& language, const std::vector<Language>& languages) {
    const auto at = std::ranges::find(languages, language.code(), &Language::code);
    return static_cast<std::size_t>(at - languages.begin());
}

void add_visit(const Language& language, std::vector<NamedScreen>& screens) {
    const FakeHouse house;
    for (std::size_t i = 0; i < visit_screen_count; ++i) {
        const auto wanted = static_cast<VisitScreen>(i);
        const auto& scenes = scenes_of_all_screens();
        const auto scene = std::ranges::find_if(
            scenes, [wanted](const Visit& visit) { return open_screen(visit) == wanted; });
        if (scene == scenes.end()) continue;
        Visit visit = *scene;
        visit.visitor.sound.language = place_of(language, house.languages);
        screens.push_back({"visit " + std::to_string(i), screen_of(visit, house.world())});
    }
}

OperatorWorld busy_world(const Language& language) {
    OperatorWorld world{language, 0.0, true, {}, {}, default_keys()};
    for (const Language& each : all_languages())
        world.languages.push_back({each.code(), each.name()});
    world.profiles = {{"child", {0, 1}}, {"expert", {2}}};
    world.kiosk.today = std::chrono::year(2026) / 3 / 1;
    for (int i = 0; i < 40; ++i)
        world.days.push_back(
            {world.kiosk.today - std::chrono::days(40 - i), {1234, 567, 89, 10, 4321, 5}});
    world.on_stick = {"shapes-and-a-boat", "animals of the forest"};
    world.kiosk.live = {"Contact: on a line", "Level: 2.5 of 6, by speed", "Force: 0.6 N"};
    world.kiosk.health.handle_trouble = spoken_fault(Fault::knob_lost, language);
    world.kiosk.health.has_motors = true;
    world.kiosk.health.homed_ago_s = 7200.0;
    world.kiosk.health.has_sound = false;
    world.kiosk.health.camera = CameraHealth::stopped;
    world.kiosk.health.can_keep = false;
    world.kiosk.health.faults_today = 5;
    world.kiosk.health.version = "1.0.0";
    return world;
}

void add_operator(const Language& language, std::vector<NamedScreen>& screens) {
    for (std::size_t i = 1; i < operator_place_count; ++i) {  // 0 is closed
        Operator state;
        state.place = static_cast<OperatorPlace>(i);
        state.wizard = start_key_wizard(0.0);
        screens.push_back(
            {"operator " + std::to_string(i), operator_screen(state, busy_world(language))});
    }
}

}  // namespace

std::vector<NamedScreen> every_screen(const Language& language) {
    std::vector<NamedScreen> screens;
    add_visit(language, screens);
    add_operator(language, screens);
    return screens;
}

}  // namespace touchline
