// A small house for a visit: twelve pictures, a stick, a camera, a handle that leads. It carries
// orders out on a virtual clock and writes down what a visitor hears and feels.
#pragma once

#include "app/session/visit.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace touchline {

/// English and all catalogues. Read once.
const std::vector<Language>& all_languages();

/// Facts of picture `index`, in a language: two pages where it comes from the stick.
PictureFacts fake_facts(const LoadPicture& order);

struct HeardText {
    double time_s = 0.0;
    std::string language;
    std::string text;
    SpeechPriority priority = SpeechPriority::text;
};

class FakeHouse {
  public:
    explicit FakeHouse(VisitRules rules = {});

    /// Carries the orders out; answers of things come by later ticks.
    void apply(const VisitEvent& event);

    void press(KeyRole role) { apply(KeyPressed{role}); }

    void press(std::initializer_list<KeyRole> roles);

    /// In steps of 50 ms, with all that comes due.
    void wait(double seconds);

    /// Down until the item has the focus, at most once round. False: there is none.
    bool find(const std::string& name);

    /// find() and Select.
    bool choose(const std::string& name);

    [[nodiscard]] SpokenScreen screen() const { return screen_of(visit, world()); }

    [[nodiscard]] VisitScreen open() const { return open_screen(visit); }

    [[nodiscard]] VisitWorld world() const { return {languages, settings, gallery, rules}; }

    /// Orders of a kind in the last step.
    template <class Order>
    [[nodiscard]] std::vector<Order> last() const {
        std::vector<Order> found;
        for (const VisitOrder& order : orders) {
            if (const auto* one = std::get_if<Order>(&order)) found.push_back(*one);
        }
        return found;
    }

    /// A sentence that was said in the last step, or since `from` of the transcript.
    [[nodiscard]] bool has_said(const std::string& part, std::size_t from) const;
    [[nodiscard]] std::string last_said() const;

    // The house may be changed between steps.
    std::vector<Language> languages = all_languages();
    Settings settings;
    std::vector<std::vector<GalleryTitle>> gallery;
    VisitRules rules;
    double load_s = 0.2;  // how long a picture takes
    double lead_s = 2.0;  // how long leading takes
    bool loads_fail = false;

    Visit visit;
    VisitOrders orders;                 // of the last step
    VisitOrders all_orders;             // of all steps
    std::vector<HeardText> transcript;  // nothing is ever taken away
    double now_s = 0.0;
    double sounded_s = 0.0;  // the last speech or cue
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
