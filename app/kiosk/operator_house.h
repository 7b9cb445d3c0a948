// The operator at one of several kiosks: bundles and keys of the house, looked at, applied and
// made. One work at a time, on a thread beside the screen's; its destructor waits for it. What
// comes while another is under way is refused, and said so.
// Threads: one.
#pragma once

#include "app/house/bundle_plan.h"
#include "app/house/places.h"
#include "app/house/signing.h"
#include "app/isolation/process/memory.h"
#include "app/kiosk/outcome.h"
#include "app/operator/operator.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// A file of the operator's stick.
struct HouseFile {
    std::string name;  // for the screen
    bool is_key = false;
    /// Its bytes, or a sentence for the operator with its line for the log. Waits for the stick.
    std::function<Result<Mapping, Outcome>()> read;
};

/// What a work came to.
struct HouseNews {
    std::optional<OperatorPlace> place;  // the screen of what was looked at
    Outcome outcome;                     // else; what is said may be empty
    bool has_changed = false;            // settings, profiles, packs or networks of this kiosk
};

class OperatorHouse {
  public:
    /// `copies`: the folder for bundles and keys that are made here.
    OperatorHouse(HousePlaces places, std::filesystem::path copies);

    void look_at(HouseFile file, std::vector<std::string> languages, const Language& language);
    void look_at_way_back(const Language& language);

    /// What was looked at last; does nothing if it was something else.
    void apply(const Language& language);
    void go_back(const Language& language);
    void trust_key(const Language& language);

    void make(const Language& language);
    void show_key(const Language& language);

    /// What there is to tell: of a work that begins, was refused, or has ended since.
    [[nodiscard]] std::optional<HouseNews> poll();

    /// Gives up what was looked at, which may be large.
    void forget() { looked_ = {}; }

    /// Of what was looked at last.
    [[nodiscard]] const std::vector<std::string>& lines() const { return looked_.lines; }

  private:
    /// What was looked at, and can be carried out as it was told.
    struct Looked {
        std::vector<std::string> lines;
        std::shared_ptr<const BundlePlan> plan;  // never copied: it holds whole packs
        std::optional<WayBack> way;
        std::optional<PublicKey> key;
    };

    struct Done {
        HouseNews news;
        Looked looked;
    };

    /// `said`: what is told at once; empty: nothing.
    void begin(std::function<Done()> work, const Language& language, const char* said = "");

    HousePlaces places_;
    std::filesystem::path copies_;
    Looked looked_;
    std::optional<HouseNews> at_once_;
    std::future<Done> work_;
};

}  // namespace touchline
