// A small simulated kiosk for a visit: twelve pictures, a stick, a camera, a handle that leads. It
// carries orders out on a virtual clock and records what a visitor hears and feels.
#pragma once

#include "app/visit/visit.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace touchline {

/// English and all catalogues, read once.
const std::vector<Language>& all_languages();

/// Facts of picture `index`, in a language; a picture of the stick has two pages.
PictureFacts fake_facts(const LoadPicture& order);

/// A part for each of its outlines.
PictureFacts facts_of_drawing(const TactileMap& map);

struct HeardText {
    double time_s = 0.0;
    std::string language;
    std::string text;
    SpeechPriority priority = SpeechPriority::text;
};

class FakeHouse {
  public:
    explicit FakeHouse(VisitRules rules = {});

    /// Steps the visit and carries its orders out; answers to slow orders come in later ticks.
    void apply(const VisitEvent& event);

    void press(KeyRole role) { apply(KeyPressed{role}); }

    void press(std::initializer_list<KeyRole> roles);

    /// Passes time in steps of 50 ms and applies all events that come due.
    void wait(double seconds);

    /// Presses Down until the item has the focus, at most once round. Returns false if there is
    /// none.
    bool find(const std::string& name);

    /// Calls find() and presses Select.
    bool choose(const std::string& name);

    /// Chooses this picture of the open list, in whichever of its parts. Knows English.
    bool choose_picture(const std::string& name);

    [[nodiscard]] SpokenScreen screen() const { return screen_of(visit, world()); }

    [[nodiscard]] VisitScreen open() const { return open_screen(visit); }

    [[nodiscard]] VisitWorld world() const { return {languages, settings, gallery, rules}; }

    /// Returns the last step's orders of this kind.
    template <class Order>
    [[nodiscard]] std::vector<Order> last() const {
        std::vector<Order> found;
        for (const VisitOrder& order : orders) {
            if (const auto* one = std::get_if<Order>(&order)) found.push_back(*one);
        }
        return found;
    }

    /// Returns true if a sentence with this part was said since `from` of the transcript.
    [[nodiscard]] bool has_said(const std::string& part, std::size_t from) const;
    [[nodiscard]] std::string last_said() const;

    // These may change between steps.
    std::vector<Language> languages = all_languages();
    Settings settings;
    std::vector<std::vector<GalleryTitle>> gallery;
    VisitRules rules;
    double load_s = 0.2;  // loading time of a picture
    double lead_s = 2.0;  // time that leading takes
    bool loads_fail = false;
    double print_s = 5.0;  // time that a sheet takes
    PrintEnd print_end = PrintEnd::printed;

    Visit visit;
    VisitOrders orders;                 // from the last step
    VisitOrders all_orders;             // from all steps
    std::vector<HeardText> transcript;  // only grows
    double now_s = 0.0;
    double sounded_s = 0.0;  // time of the last speech or cue
    bool is_leading = false;

  private:
    struct Due {
        double time_s;
        VisitEvent event;
    };

    void carry_out(const VisitOrder& order);
    void carry_out_load(const LoadPicture& order);
    void come_due();

    std::vector<Due> due_;
};

}  // namespace touchline
