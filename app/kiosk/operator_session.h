// The operator's screens at work: carries out their orders on files, and keeps their state. Servo,
// sound and stick are left to the kiosk (kiosk_operator.cpp).
// Threads: one. Its calls read and write small files; a thread beside it reads sticks.
#pragma once

#include "app/kiosk/operator_house.h"
#include "app/kiosk/outcome.h"
#include "app/kiosk/stick_source.h"
#include "app/operator/counters.h"
#include "app/operator/operator.h"
#include "app/operator/pin.h"
#include "app/operator/settings_files.h"
#include "app/visit/visit_orders.h"
#include "audio-cues/words/language.h"
#include "config/types/result.h"
#include "config/types/tactile_map.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// Where the site keeps what the operator sets.
struct OperatorFiles {
    SettingsFiles settings;
    std::filesystem::path pin;
    std::filesystem::path counters;
    std::filesystem::path keys;
    std::filesystem::path sound;
    std::filesystem::path profiles;  // folder of the installed profiles
    std::filesystem::path copies;    // folder of backups and logs
    std::filesystem::path library;   // folder of picture packs
    std::string import_program;      // touchline-import, which reads sticks
    HousePlaces house;               // of several kiosks
};

/// The files of this machine.
[[nodiscard]] OperatorFiles operator_files();

class OperatorSession {
  public:
    /// Adds a line to `problems` for every file that could not be used.
    OperatorSession(OperatorFiles files, const std::vector<Language>& languages,
                    std::vector<std::string>& problems);

    [[nodiscard]] bool is_open() const { return state_.place != OperatorPlace::closed; }

    /// True once the PIN was given.
    [[nodiscard]] bool is_inside() const { return touchline::is_inside(state_.place); }

    /// True while the next key that goes down is one to be learned.
    [[nodiscard]] bool is_learning_keys() const {
        return state_.place == OperatorPlace::key_wizard;
    }

    /// True if the site has a PIN: looks for its file.
    [[nodiscard]] bool has_pin() const { return touchline::has_pin(files_.pin); }

    [[nodiscard]] SpokenScreen screen(const Language& language) const;

    /// Returns what the kiosk itself has to do about the event.
    [[nodiscard]] std::vector<OperatorOrder> apply(const OperatorEvent& event,
                                                   const Language& language, double now_s);

    /// Sets the stick that is plugged in; empty: none. Only an operator who gave the PIN can take
    /// its files into the library; before that they are not even listed.
    void put_stick(const std::string& root) { stick_.look_at(is_inside() ? root : ""); }

    /// `facts`: with the health of all that the session does not know itself.
    void see(KioskFacts facts) { facts_ = std::move(facts); }

    /// The site's settings with those of the profile over them.
    [[nodiscard]] const Settings& settings() const { return settings_; }

    [[nodiscard]] const KeyTable& keys() const { return keys_; }

    [[nodiscard]] const SoundSettings& sound() const { return sound_; }

    /// True if a file can be written beside the settings.
    [[nodiscard]] bool can_write() const;

    /// Reads settings and profiles again if somebody else changed the settings, or applied a bundle
    /// or took it back; not while a value is turned here. True if so: settings() may say something
    /// new.
    [[nodiscard]] bool read_again();

    // What is counted, on this day of the site's clock.
    void count_picture(PictureSource source, std::chrono::sys_days today);
    void count_visit(double minutes, std::chrono::sys_days today);

    /// `began`: how many faults began since the last call. Call it once a second at least.
    void count_faults(std::uint64_t began, std::chrono::sys_days today, double now_s);

    /// Writes the drawing beside the other copies, as a map SVG under the next free number. Returns
    /// one sentence for the operator.
    [[nodiscard]] std::string keep_drawing(const TactileMap& drawing, const Language& language);

    /// Adds a line to the log that can be exported; it keeps the last 1000 lines.
    void log(const std::string& line);

    /// What came of a bundle or a key, as events for apply(). Afterwards read_again() may be true.
    [[nodiscard]] std::vector<OperatorEvent> poll_house();

    /// One sentence for the operator: an import ended, or the stick cannot be read.
    [[nodiscard]] std::optional<std::string> poll_stick(const Language& language);

    /// One line for the log; empty: nothing new.
    [[nodiscard]] std::string take_note() { return std::exchange(note_, {}); }

  private:
    struct Office;

    void count_tries_on(double now_s);
    [[nodiscard]] OperatorWorld world(const Language& language, double now_s) const;
    void read_site(std::vector<std::string>& problems);
    void hold(const Settings& site);
    [[nodiscard]] std::optional<Settings> merged(const WriteSettings& write) const;
    [[nodiscard]] std::string back_up(const Language& language);
    [[nodiscard]] std::string restore(const Language& language);
    [[nodiscard]] std::string copy(const std::string& text, const std::string& file,
                                   const char* said, const Language& language);
    [[nodiscard]] std::string told(Outcome outcome);
    void import_from_stick(std::size_t file, const Language& language);
    void keep_counts();
    void look_at_house_file(std::size_t file, const Language& language);

    /// The numbers of the stick's files that are for several kiosks, or of all others.
    [[nodiscard]] std::vector<std::size_t> stick_files(bool are_of_house) const;
    [[nodiscard]] std::vector<std::string> stick_names(bool are_of_house) const;

    OperatorFiles files_;
    FileWatch watch_;
    FileWatch applied_;  // of the last bundle, which may bring profiles alone
    std::vector<OfferedLanguage> languages_;
    std::vector<Profile> profiles_;
    Operator state_;
    std::optional<int> wrong_pins_;  // of the last run, until the time is known
    Settings site_;
    Settings settings_;
    SoundSettings sound_;
    KeyTable keys_;
    CountedDays days_;
    bool is_fault_unkept_ = false;
    double fault_kept_s_ = -1e9;
    KioskFacts facts_;
    OperatorStick stick_;
    std::future<Outcome> import_;
    OperatorHouse house_;
    bool has_new_site_ = false;  // a bundle was applied, or undone
    std::vector<std::string> log_;
    std::string note_;
    bool can_keep_ = true;  // as it was last told
};

}  // namespace touchline
