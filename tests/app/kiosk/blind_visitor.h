// Who is at the kiosk in a test: a visitor who knows only what was said, or what stood on the
// braille line, presses one of six keys and moves the handle; an operator who does the same, also
// while a visit runs; and a hand that feels the walls of a picture of the gallery: the force that
// the simulated motors make and the true place of the tip. Threads: one.
#pragma once

#include "tests/app/kiosk/kiosk_world.h"

#include <initializer_list>
#include <string>

namespace touchline {

/// By which words reach a visitor. fingers: reads all that can be paged to after each key, and has
/// no other keys than those of the display.
enum class Sense : unsigned char { ears, fingers };

class BlindVisitor {
  public:
    /// `pause_s`: the time between two keys.
    explicit BlindVisitor(KioskWorld& world, double pause_s = 0.5, Sense sense = Sense::ears);

    /// Goes down the list until an item begins with these words as it is said. Returns false if the
    /// list came round without one.
    [[nodiscard]] bool find(const std::string& item);

    /// Finds the item and selects it. heard() then returns what was said since.
    [[nodiscard]] bool choose(const std::string& item);

    /// Chooses a picture of the open list, and hears each of its parts until one has it.
    [[nodiscard]] bool choose_picture(const std::string& name);

    void press(KeyRole role);

    /// Returns all that was said since the last key; by fingers, what was read since, in braille.
    [[nodiscard]] std::string heard() const;

    /// Whether these words were among it.
    [[nodiscard]] bool has_heard(const std::string& words) const;

    /// Waits until something with these words is said. Returns false if that takes longer.
    [[nodiscard]] bool wait_for(const std::string& words, double most_s = 20.0);

    /// Returns the longest answer to any key so far: from the key to the first sound or word.
    [[nodiscard]] double slowest_answer_s() const { return slowest_answer_s_; }

    [[nodiscard]] int keys() const { return keys_; }

  private:
    [[nodiscard]] bool has_item(const std::string& item) const;
    [[nodiscard]] std::string as_heard(const std::string& words) const;
    [[nodiscard]] bool is_answered(const std::string& page_before) const;
    void read_page();
    void read_on();

    KioskWorld& world_;
    double pause_s_;
    Sense sense_;
    std::string read_;
    std::string page_;          // read last
    std::uint32_t shakes_ = 0;  // of the handle, before the last key
    std::size_t since_ = 0;
    double slowest_answer_s_ = 0.0;
    int keys_ = 0;
};

/// Begins a visit in English and opens a picture of the gallery.
void open_gallery_picture(BlindVisitor& visitor, const std::string& picture);

/// Presses the keys that open the operator's screens.
void enter(BlindVisitor& staff);

/// Enters the digits 1, 2, 3, 4.
void enter_pin(BlindVisitor& staff);

/// Calls enter() and sets a new PIN, which opens the operator's first screen.
void open_status(BlindVisitor& staff);

/// Calls open_status() and goes back to the menu.
void open_menu(BlindVisitor& staff);

/// Calls open_menu(), goes down to a setting by these names, and holds it.
void hold_setting(BlindVisitor& staff, std::initializer_list<const char*> names);

/// Turns the held setting down to its least value.
void turn_to_least(BlindVisitor& staff);

/// A kiosk that reads the files of pictures beforehand, so that only the virtual clock passes time.
class WallWorld : public KioskWorld {
  public:
    WallWorld() : KioskWorld(false, gallery_without_workers()) {}
};

/// Goes from the start of the kiosk to the picture, by the visitor's keys.
void open_walls(KioskWorld& world, const std::string& picture);

/// Moves the hand straight there, slowly enough for every speed limit.
void lead_hand(KioskWorld& world, Position place_W);

struct FeltWall {
    double stiffness_N_per_m = 0.0;  // added force over added depth behind the proxy
    double most_force_N = 0.0;
};

/// The hand pushes lightly, then aims for `deep`, behind a wall; both times it slides on by
/// `along`. It pushes twice because encoders that round down place the whole wall half a step off;
/// sliding averages their steps. Then the hand goes back to where it was.
[[nodiscard]] FeltWall feel_wall(KioskWorld& world, Position deep, Position along);

}  // namespace touchline
