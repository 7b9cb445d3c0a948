// A held shape: chosen, turned, told. Only where the site offers it.
#include "app/session/screen_writer.h"

#include <cmath>
#include <numbers>
#include <string>

namespace touchline {
namespace {

constexpr int degrees_a_key = 15;
constexpr const char* turn_hint = "Press Select to turn it a little. A knob turns it too.";
constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// The turn from the start, the short way round; left is counter-clockwise.
std::string told_turn(double turn_rad, const Language& language) {
    const int degrees =
        static_cast<int>(std::lround(std::remainder(degrees_per_radian * turn_rad, 360.0)));
    if (degrees == 0) return language.text("visit", "not turned");
    const int turned = std::abs(degrees);
    return degrees > 0 ? language.counted("visit", "turned left by {0} degree",
                                          "turned left by {0} degrees", turned)
                       : language.counted("visit", "turned right by {0} degree",
                                          "turned right by {0} degrees", turned);
}

}  // namespace

void put_shape(ScreenWriter& sheet) {
    const Feel& feel = sheet.visit.visitor.feel;
    sheet.setting(VisitItem::held_shape);
    sheet.screen.items.back().hint = sheet.words("For the curious: lines push and twist it.");
    if (feel.shape == HeldShape::none) return;
    sheet.sentence("You hold a shape. It works once no line goes through it.");
    const std::string turned = told_turn(feel.turn_rad, sheet.language);
    sheet.item(VisitItem::turn_left, "Turn it left", turned, turn_hint);
    sheet.item(VisitItem::turn_right, "Turn it right", turned, turn_hint);
    sheet.item(VisitItem::turn_back, "Turn it back");
}

void turn_shape(VisitWork& work, VisitItem item) {
    double& turn_rad = work.visitor.feel.turn_rad;
    const double step_rad = degrees_a_key / degrees_per_radian;
    // Goes to the next step, wherever a knob left the shape.
    const double steps = turn_rad / step_rad;
    if (item == VisitItem::turn_left) turn_rad = step_rad * (std::floor(steps + 1e-6) + 1.0);
    if (item == VisitItem::turn_right) turn_rad = step_rad * (std::ceil(steps - 1e-6) - 1.0);
    if (item == VisitItem::turn_back) turn_rad = 0.0;
    say(work, told_turn(turn_rad, language_of(work)));
}

void follow_knob(VisitWork& work, double by_rad) {
    Visitor& visitor = work.visitor;
    if (visitor.feel.shape == HeldShape::none || !std::isfinite(by_rad)) return;
    visitor.active_s = work.site.now_s;
    visitor.feel.turn_rad += by_rad;
}

}  // namespace touchline
