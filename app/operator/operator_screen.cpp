#include "app/operator/operator_items.h"
#include "app/operator/operator_places.h"

#include <algorithm>

namespace touchline {
namespace {

std::string own_text(const Operator& state, const OperatorWorld& world) {
    const auto words = [&](std::string_view english) {
        return english.empty() ? "" : world.language.text("operator", std::string(english));
    };
    std::string text = words(row_of(state.place).text);
    if (state.place == OperatorPlace::question) text = words(words_of(state.question));
    if (state.place == OperatorPlace::library && world.on_stick.empty())
        text = words(
            "Put in a USB stick with packs of pictures. A network file for Touchline can be on it "
            "too.");
    return text;
}

}  // namespace

SpokenScreen operator_screen(const Operator& state, const OperatorWorld& world) {
    SpokenScreen screen;
    if (state.place == OperatorPlace::key_wizard)
        screen = wizard_screen(state.wizard, world.language);
    else if (state.place == OperatorPlace::test_step)
        screen = test_screen(state.test, world.language);
    else {
        screen.title = world.language.text("operator", std::string(row_of(state.place).title));
        screen.text = own_text(state, world);
        screen.items = operator_items(state, world);
        if (!screen.items.empty()) screen.focus = std::min(state.focus, screen.items.size() - 1);
    }
    add_sentence(screen.text, state.note);
    if (state.place == OperatorPlace::live) screen.view = ScreenView::picture;
    return screen;
}

}  // namespace touchline
