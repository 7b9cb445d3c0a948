#include "tests/app/kiosk/blind_visitor.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr int longest_list = 80;

constexpr double felt_frame_s = 1.0 / 60.0;
constexpr double hand_m_per_s = 0.04;

Position meant(KioskWorld& world) {
    return world.servo().hand().at(0.0).position;
}

/// Averages while the hand slides.
struct Push {
    double force_N = 0.0;
    double depth_m = 0.0;
};

Push push(KioskWorld& world, Position meant_W, Position along) {
    constexpr double settle_s = 0.5;
    constexpr int samples = 60;
    lead_hand(world, meant_W);
    world.run(settle_s);
    Push felt;
    for (int i = 1; i <= samples; ++i) {
        world.servo().hand().move_to(meant_W + (static_cast<double>(i) / samples) * along);
        world.run(felt_frame_s);
        felt.force_N += norm(world.servo().force_on_handle_W()) / samples;
        felt.depth_m += norm(world.kiosk().hand().p_WP - world.servo().handle_W()) / samples;
    }
    return felt;
}

}  // namespace

BlindVisitor::BlindVisitor(KioskWorld& world, double pause_s, Sense sense)
    : world_(world), pause_s_(pause_s), sense_(sense) {
    world_.line().is_plugged_in = sense == Sense::fingers;
}

void BlindVisitor::press(KeyRole role) {
    since_ = world_.heard().things.size();
    read_.clear();
    shakes_ = world_.servo().commands().pattern.serial;
    const std::string page_before = world_.line().page();
    const double pressed_s = world_.now_s();
    if (sense_ == Sense::ears) {
        world_.press(role);
    } else {
        world_.line().press(role);
        world_.run(0.01);
    }
    ++keys_;
    double answer_s = 1e9;
    if (sense_ == Sense::ears && world_.heard().things.size() > since_)
        answer_s = world_.heard().things[since_].at_s - pressed_s;
    if (sense_ == Sense::fingers && is_answered(page_before)) answer_s = world_.now_s() - pressed_s;
    slowest_answer_s_ = std::max(slowest_answer_s_, answer_s);
    world_.run(pause_s_);
    if (sense_ == Sense::fingers) read_on();
}

/// Hands know of it by the line or the handle.
bool BlindVisitor::is_answered(const std::string& page_before) const {
    return world_.line().page() != page_before ||
           world_.servo().commands().pattern.serial != shakes_;
}

void BlindVisitor::read_page() {
    page_ = world_.line().page();
    read_ += (world_.line().is_beginning() ? '\n' : ' ') + page_;
}

/// Reads the page that is there, and those after it.
void BlindVisitor::read_on() {
    constexpr double page_s = 0.4;
    constexpr int most_pages = 100;
    read_page();
    for (int i = 0; i < most_pages; ++i) {
        world_.line().turn(LineTurn::on);
        const bool is_end = std::get<LineTurned>(world_.line().events.back()).is_at_end;
        world_.run(page_s);
        if (is_end && world_.line().page() == page_) return;
        read_page();
    }
    FAIL() << "the line has no end: " << read_;
}

std::string BlindVisitor::heard() const {
    return sense_ == Sense::ears ? world_.heard().text_since(since_) : read_;
}

std::string BlindVisitor::as_heard(const std::string& words) const {
    return sense_ == Sense::ears ? words : as_read(words, world_.kiosk().language().code());
}

bool BlindVisitor::has_heard(const std::string& words) const {
    return heard().find(as_heard(words)) != std::string::npos;
}

/// Whether any text begins with this item; a sentence says its item first. A language is listed in
/// itself, on the display in its own braille.
bool BlindVisitor::has_item(const std::string& item) const {
    const auto begins = [heard = "\n" + heard()](const std::string& text) {
        return heard.find("\n" + text) != std::string::npos;
    };
    if (begins(as_heard(item)) || sense_ == Sense::ears) return begins(as_heard(item));
    return std::ranges::any_of(all_languages(), [&](const Language& language) {
        return language.name() == item && begins(as_read(item, language.code()));
    });
}

bool BlindVisitor::find(const std::string& item) {
    for (int i = 0; i < longest_list; ++i) {
        if (has_item(item)) return true;
        press(KeyRole::down);
    }
    return has_item(item);
}

bool BlindVisitor::choose(const std::string& item) {
    press(KeyRole::up);  // coming back to the item with the focus says it
    press(KeyRole::down);
    if (!find(item)) return false;
    press(KeyRole::select);
    return true;
}

bool BlindVisitor::choose_picture(const std::string& name) {
    const Language& language = world_.kiosk().language();
    const std::string of_picture =
        language.text("visit", "picture {0} of {1}", {"", ""}).substr(0, 4);
    const std::size_t count = world_.kiosk().screen().items.size();
    for (std::size_t i = 0; i < count; ++i) {
        press(KeyRole::down);
        const SpokenScreen now = world_.kiosk().screen();
        const std::string place = now.items[*now.focus].place.value_or("");
        const bool is_picture = place.starts_with(of_picture);
        const bool is_way_out = place.empty();
        if (is_way_out || (is_picture && !has_item(name))) continue;
        press(KeyRole::select);
        if (is_picture || choose_picture(name)) return true;
        press(KeyRole::back);
    }
    return false;
}

bool BlindVisitor::wait_for(const std::string& words, double most_s) {
    for (double waited_s = 0.0; waited_s < most_s; waited_s += 0.25) {
        if (has_heard(words)) return true;
        world_.run(0.25);
        if (sense_ == Sense::fingers && world_.line().page() != page_) read_on();
    }
    return false;
}

void enter(BlindVisitor& staff) {
    for (const KeyRole role :
         {KeyRole::help, KeyRole::up, KeyRole::up, KeyRole::down, KeyRole::down, KeyRole::select})
        staff.press(role);
}

void enter_pin(BlindVisitor& staff) {
    for (int digit = 1; digit <= 4; ++digit) {
        for (int i = 0; i < digit; ++i) staff.press(KeyRole::up);
        staff.press(KeyRole::select);
    }
    staff.press(KeyRole::select);
}

void open_status(BlindVisitor& staff) {
    enter(staff);
    enter_pin(staff);
    enter_pin(staff);
}

void open_menu(BlindVisitor& staff) {
    open_status(staff);
    staff.press(KeyRole::back);
}

void hold_setting(BlindVisitor& staff, std::initializer_list<const char*> names) {
    open_menu(staff);
    for (const char* name : names) ASSERT_TRUE(staff.choose(name)) << staff.heard();
}

void turn_to_least(BlindVisitor& staff) {
    constexpr int most_steps = 100;
    for (int i = 0; i < most_steps; ++i) {
        staff.press(KeyRole::down);
        if (staff.heard().find("It goes no further.") != std::string::npos) return;
    }
    FAIL() << staff.heard();
}

void open_gallery_picture(BlindVisitor& visitor, const std::string& picture) {
    visitor.press(KeyRole::select);
    ASSERT_TRUE(visitor.choose("English")) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("What to feel")) << visitor.heard();
    ASSERT_TRUE(visitor.choose("Gallery")) << visitor.heard();
    ASSERT_TRUE(visitor.choose_picture(picture)) << visitor.heard();
    ASSERT_TRUE(visitor.wait_for("Guide me along the")) << visitor.heard();
}

void open_walls(KioskWorld& world, const std::string& picture) {
    std::ofstream(world.site_files().settings.site) << "[feel]\nmode = \"wall\"\n";
    world.run(2.0);
    BlindVisitor visitor(world, 0.2);
    ASSERT_NO_FATAL_FAILURE(open_gallery_picture(visitor, picture));
    world.run(1.0);
}

void lead_hand(KioskWorld& world, Position place_W) {
    const Position from = meant(world);
    const double way_m = norm(place_W - from);
    const int frames = static_cast<int>(std::ceil(way_m / (hand_m_per_s * felt_frame_s)));
    for (int i = 1; i <= frames; ++i) {
        world.servo().hand().move_to(from + (static_cast<double>(i) / frames) * (place_W - from));
        world.run(felt_frame_s);
    }
}

FeltWall feel_wall(KioskWorld& world, Position deep, Position along) {
    constexpr double light_share = 0.56;  // share of the way to `deep`: just behind the wall
    const Position before = meant(world);
    const Push light = push(world, before + light_share * (deep - before), along);
    const Push hard = push(world, deep, along);
    lead_hand(world, before);
    return {(hard.force_N - light.force_N) / (hard.depth_m - light.depth_m), hard.force_N};
}

}  // namespace touchline
