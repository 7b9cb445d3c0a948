#include "tests/app/screen/every_screen.h"

#include "app/visit/told_lines.h"
#include "tests/app/visit/fake_world.h"
#include "tests/app/visit/visit_scenes.h"

#include <algorithm>
#include <string>
#include <utility>

namespace touchline {
namespace {

std::size_t place_of(const Language& language, const std::vector<Language>& languages) {
    const auto at = std::ranges::find(languages, language.code(), &Language::code);
    return static_cast<std::size_t>(at - languages.begin());
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
    world.house_files = {"house", "all kiosks"};
    world.house_lines = {"6 3 2 9", "6 9 5 1", "3 5 4 7", "6 2 9 8", "9 1 8 9", "4 0 8 9"};
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

}  // namespace

std::optional<SpokenScreen> visit_screen(VisitScreen wanted, const Language& language) {
    const auto& scenes = scenes_of_all_screens();
    const auto scene = std::ranges::find_if(scenes, [wanted](const Visit& visit) {
        return open_screen(visit) == wanted && !visit.visitor.drawing;
    });
    if (scene == scenes.end()) return std::nullopt;
    FakeHouse house;
    house.settings.offers_drawing = false;  // as a house is at first
    Visit visit = *scene;
    visit.visitor.sound.language = place_of(language, house.languages);
    return screen_of(visit, house.world());
}

SpokenScreen drawing_screen(const Language& language) {
    FakeHouse house;
    house.rules.sound.language = place_of(language, house.languages);
    house.press({KeyRole::select, KeyRole::select});
    const auto place = place_of(house.screen().items, static_cast<int>(VisitItem::draw_for_me));
    for (std::size_t i = 0; i < place.value(); ++i) house.press(KeyRole::down);
    house.press(KeyRole::select);
    for (const double y_m : {-0.02, 0.02}) house.apply(PenStroke{{{-0.03, y_m}, {0.03, y_m}}});
    house.wait(0.1);
    return house.screen();
}

SpokenScreen staff_screen(OperatorPlace place, const Language& language) {
    Operator state;
    state.place = place;
    state.wizard = start_key_wizard(0.0);
    return operator_screen(state, busy_world(language));
}

std::vector<NamedScreen> every_screen(const Language& language) {
    std::vector<NamedScreen> screens;
    const auto add = [&screens](const std::string& whose, std::size_t number, SpokenScreen screen) {
        const std::string name = whose + ' ' + std::to_string(number) + ": " + screen.title;
        screens.push_back({name, std::move(screen)});
    };
    for (std::size_t i = 0; i < visit_screen_count; ++i)
        if (auto screen = visit_screen(static_cast<VisitScreen>(i), language))
            add("visit", i, std::move(*screen));
    add("visit", visit_screen_count, drawing_screen(language));
    for (std::size_t i = 1; i < operator_place_count; ++i)  // 0 is closed
        add("staff", i, staff_screen(static_cast<OperatorPlace>(i), language));
    return screens;
}

}  // namespace touchline
