#include "app/kiosk/operator_session.h"

#include "app/documents/decode/map_svg.h"
#include "app/documents/models/networks.h"
#include "app/house/changing.h"
#include "app/isolation/process/places.h"
#include "app/kiosk/operator_import.h"
#include "app/kiosk/own_thread.h"
#include "app/operator/backup.h"
#include "app/operator/pin.h"
#include "app/operator/settings_files.h"
#include "config/settings/setting_rows.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <system_error>
#include <type_traits>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_log = 1000;

// Said if a file could not be written or read; the log has the details.
constexpr const char* no_pin = "The PIN cannot be saved. Make room on the disk.";
constexpr const char* no_settings = "The settings cannot be saved. Make room on the disk.";
constexpr const char* not_together = "That does not go together with another setting.";
constexpr const char* no_keys = "The keys cannot be saved. Make room on the disk.";
constexpr const char* no_counters = "The counters cannot be saved. Make room on the disk.";
constexpr const char* no_copy = "The copy cannot be written. Make room on the disk.";
constexpr const char* no_good_copy = "There is no copy that can be used. Copy the settings first.";

NetworkHealth network_health() {
    NetworkHealth health;
    for (const Network& network : networks()) {
        if (is_installed(network)) continue;
        ++health.missing;
        health.lacks_shipped = health.lacks_shipped || network.ships;
    }
    return health;
}

}  // namespace

OperatorFiles operator_files() {
    const fs::path folder = settings_files().site.parent_path();
    return {settings_files(),  pin_file(),        counters_file(),
            keys_file(),       site_sound_file(), profiles_folder(),
            folder / "copies", library_folder(),  companion("touchline-import"),
            house_places()};
}

/// Carries out what concerns only files; leaves everything else to the kiosk.
struct OperatorSession::Office {
    OperatorSession& session;
    const Language& language;
    double now_s;
    std::vector<OperatorOrder>& left;

    void tell(const OperatorEvent& event) const {
        for (OperatorOrder& order : session.apply(event, language, now_s))
            left.push_back(std::move(order));
    }

    void answer(const std::string& line) const { tell(OrderAnswered{plain_line(line)}); }

    /// Says nothing of a success.
    void judge(const Result<void>& kept, const char* why_not) const {
        if (!kept) answer(session.told(outcome_of(kept, "", why_not, language)));
    }

    /// Counts it as wrong first: pulling the plug before the answer still costs a try.
    void operator()(const CheckPin& check) const {
        const fs::path tries = pin_tries_file(session.files_.pin);
        const auto noted = keep_pin_tries(tries, session.state_.tries.wrong + 1);
        if (!noted) session.note_ = noted.error().line;
        const auto right = is_right_pin(session.files_.pin, check.pin);
        if (!right) session.note_ = right.error().line;
        if (right.value_or(false)) forget_tries(tries);
        tell(PinChecked{right.value_or(false), noted.has_value()});
    }

    void forget_tries(const fs::path& tries) const {
        const auto forgotten = keep_pin_tries(tries, 0);
        if (!forgotten) session.note_ = forgotten.error().line;
    }

    void operator()(const KeepPin& keep) const {
        const auto kept = keep_pin(session.files_.pin, keep.pin);
        if (!kept) return judge(kept, no_pin);
        forget_tries(pin_tries_file(session.files_.pin));
    }

    void operator()(const SetSettings& set) const {
        // Tried, not kept: the site's own stay as in its file.
        session.settings_ = with_profile(set.settings, session.profiles_).value_or(set.settings);
        left.emplace_back(set);
    }

    void operator()(const WriteSettings& write) const {
        const auto wanted = session.merged(write);
        if (!wanted) return answer(language.text("operator", not_together));
        const auto kept = keep_settings(session.files_.settings, *wanted);
        session.state_.settings = *wanted;
        (void)session.watch_.has_changed();
        session.hold(*wanted);
        left.emplace_back(write);
        judge(kept, no_settings);
    }

    void operator()(const WriteSound& write) const {
        session.sound_ = write.sound;
        const auto kept = keep_sound(session.files_.sound, write.sound);
        left.emplace_back(write);
        judge(kept, no_settings);
    }

    void operator()(const WriteKeys& write) const {
        session.keys_ = write.keys;
        const auto kept = keep_keys(session.files_.keys, write.keys);
        left.emplace_back(write);
        judge(kept, no_keys);
    }

    void operator()(const ZeroCounters&) const {
        session.days_.clear();
        judge(keep_counters(session.files_.counters, session.days_), no_counters);
    }

    void operator()(const ExportCounters&) const {
        answer(session.copy(counters_csv(session.days_), "touchline-days.csv",
                            "The table is in {0}.", language));
    }

    void operator()(const BackUp&) const { answer(session.back_up(language)); }

    void operator()(const Restore&) const {
        const std::string line = session.restore(language);
        left.emplace_back(WriteSettings{session.site_});
        left.emplace_back(WriteKeys{session.keys_});
        answer(line);
    }

    void operator()(const ExportLog&) const {
        std::string text;
        for (const std::string& line : session.log_) text += line + '\n';
        answer(session.copy(text, "touchline-log.txt", "The log is in {0}.", language));
    }

    void operator()(const ImportFromStick& import) const {
        session.import_from_stick(import.file, language);
    }

    void operator()(const LookAtHouseFile& look) const {
        session.look_at_house_file(look.file, language);
    }

    void operator()(const LookAtWayBack&) const { session.house_.look_at_way_back(language); }

    void operator()(const ApplyBundle&) const { session.house_.apply(language); }

    void operator()(const GoBackToBefore&) const { session.house_.go_back(language); }

    void operator()(const MakeBundle&) const { session.house_.make(language); }

    void operator()(const ShowHouseKey&) const { session.house_.show_key(language); }

    void operator()(const TrustHouseKey&) const { session.house_.trust_key(language); }

    template <class Order>
    void operator()(const Order& order) const {
        left.emplace_back(order);
    }
};

OperatorSession::OperatorSession(OperatorFiles files, const std::vector<Language>& languages,
                                 std::vector<std::string>& problems)
    : files_(std::move(files)),
      watch_(files_.settings.site),
      applied_(change_record_file(files_.house)),
      stick_(files_.import_program),
      house_(files_.house, files_.copies) {
    if (const auto done = finish_change(files_.house); !done) problems.push_back(done.error().line);
    for (const Language& language : languages)
        languages_.push_back({language.code(), language.name()});
    read_site(problems);
    KeptKeys keys = read_keys(files_.keys);
    if (!keys.note.empty()) problems.push_back(keys.note);
    keys_ = std::move(keys.keys);
    if (fs::exists(files_.sound)) {
        const auto sound = read_sound(files_.sound);
        if (sound) sound_ = *sound;
    }
    const auto days = read_counters(files_.counters);
    if (!days) problems.push_back(days.error().line);
    days_ = days.value_or(CountedDays{});
    const auto wrong_pins = read_pin_tries(pin_tries_file(files_.pin));
    if (!wrong_pins) problems.push_back(wrong_pins.error().line);
    wrong_pins_ = wrong_pins.value_or(most_wrong_pins);
    can_keep_ = can_write();
    if (!can_keep_)
        problems.push_back("nothing can be kept in " + files_.counters.parent_path().string() +
                           ": make room on its disk, and let the kiosk write there");
}

void OperatorSession::read_site(std::vector<std::string>& problems) {
    profiles_ = read_profiles(files_.profiles, files_.house.profiles, problems);
    KeptSettings kept = read_settings(files_.settings);
    if (!kept.note.empty()) problems.push_back(std::move(kept.note));
    hold(kept.settings);
    if (!note_.empty()) problems.push_back(take_note());
}

void OperatorSession::hold(const Settings& site) {
    site_ = site;
    const auto held = with_profile(site, profiles_);
    if (!held) note_ = held.error().line;
    settings_ = held.value_or(site);
}

/// Adds what a shell wrote since the file was read last. Nothing if both do not go together.
std::optional<Settings> OperatorSession::merged(const WriteSettings& write) const {
    if (write.is_whole) return write.settings;
    const Settings now = read_settings(files_.settings).settings;
    const Settings both = with_changes(now, site_, write.settings);
    return conflicts(both).empty() ? std::optional(both) : std::nullopt;
}

bool OperatorSession::read_again() {
    if (is_editing(state_)) return false;
    const bool is_new = std::exchange(has_new_site_, false);
    const bool is_set = watch_.has_changed();
    const bool is_applied = applied_.has_changed();
    if (!is_new && !is_set && !is_applied) return false;
    std::vector<std::string> problems;
    read_site(problems);
    if (!problems.empty()) note_ = std::move(problems.back());
    return true;
}

OperatorWorld OperatorSession::world(const Language& language, double now_s) const {
    OperatorWorld world{language,
                        now_s,
                        has_pin(),
                        site_,
                        sound_,
                        keys_,
                        languages_,
                        {},
                        days_,
                        stick_names(false),
                        stick_names(true),
                        house_.lines(),
                        facts_};
    for (const Profile& profile : profiles_) world.profiles.push_back({profile.name, profile.rows});
    KioskHealth& health = world.kiosk.health;
    health.can_keep = can_keep_;
    health.version = TOUCHLINE_VERSION;
    const auto day = std::ranges::find(days_, facts_.today, &CountedDay::day);
    if (day != days_.end()) health.faults_today = day->counts.faults;
    if (is_inside()) health.networks = network_health();
    return world;
}

SpokenScreen OperatorSession::screen(const Language& language) const {
    return operator_screen(state_, world(language, 0.0));
}

std::vector<OperatorOrder> OperatorSession::apply(const OperatorEvent& event,
                                                  const Language& language, double now_s) {
    count_tries_on(now_s);
    OperatorStep step = step_operator(state_, event, world(language, now_s));
    state_ = std::move(step.state);
    std::vector<OperatorOrder> left;
    for (const OperatorOrder& order : step.orders)
        std::visit(Office{*this, language, now_s, left}, order);
    return left;
}

void OperatorSession::count_tries_on(double now_s) {
    if (const auto wrong = std::exchange(wrong_pins_, std::nullopt))
        state_.tries = tries_after_restart(*wrong, now_s);
}

std::string OperatorSession::told(Outcome outcome) {
    if (!outcome.line.empty()) note_ = std::move(outcome.line);
    return std::move(outcome.said);
}

std::string OperatorSession::back_up(const Language& language) {
    std::error_code error;
    fs::create_directories(files_.copies, error);
    return told(outcome_of(
        write_backup(files_.copies, {site_, sound_, keys_}),
        language.text("operator", "The copy is in {0}.", {files_.copies.filename().string()}),
        no_copy, language));
}

std::string OperatorSession::restore(const Language& language) {
    const auto backup = read_backup(files_.copies);
    if (!backup) return told({language.text("operator", no_good_copy), backup.error().line});
    sound_ = backup->sound;
    keys_ = backup->keys;
    const auto kept = keep_settings(files_.settings, backup->settings)
                          .and_then([&] { return keep_sound(files_.sound, sound_); })
                          .and_then([&] { return keep_keys(files_.keys, keys_); });
    (void)watch_.has_changed();
    hold(backup->settings);
    return told(outcome_of(kept, language.text("operator", "All settings are as in the copy."),
                           no_settings, language));
}

std::string OperatorSession::copy(const std::string& text, const std::string& file,
                                  const char* said, const Language& language) {
    const std::string folder = files_.copies.filename().string();
    return told(outcome_of(keep_text(files_.copies / file, text),
                           language.text("operator", said, {folder}), no_copy, language));
}

std::string OperatorSession::keep_drawing(const TactileMap& drawing, const Language& language) {
    std::error_code error;
    const auto name = [](int number) {
        return "touchline-drawing-" + std::to_string(number) + ".svg";
    };
    int number = 1;
    while (fs::exists(files_.copies / name(number), error)) ++number;
    return copy(format_map_svg(drawing), name(number), "The drawing is in {0}.", language);
}

void OperatorSession::import_from_stick(std::size_t file, const Language& language) {
    const auto files = stick_files(false);
    if (file >= files.size() || import_.valid()) return;
    const std::size_t at = files[file];
    import_ = on_own_thread(
        [file = Brought{reader_of(stick_, at, language), stick_.kind_of(at), stick_.names()[at]},
         library = files_.library, language] { return imported(file, library, language); },
        Outcome{language.text("operator", "There is not enough memory for this file."), ""});
}

void OperatorSession::look_at_house_file(std::size_t file, const Language& language) {
    const auto files = stick_files(true);
    if (file >= files.size()) return;
    const std::size_t at = files[file];
    std::vector<std::string> codes;
    for (const OfferedLanguage& each : languages_) codes.push_back(each.code);
    house_.look_at({stick_.names()[at], stick_.kind_of(at) == StickFileKind::house_key,
                    reader_of(stick_, at, language)},
                   std::move(codes), language);
}

std::vector<std::size_t> OperatorSession::stick_files(bool are_of_house) const {
    std::vector<std::size_t> files;
    for (std::size_t i = 0; i < stick_.names().size(); ++i) {
        const StickFileKind kind = stick_.kind_of(i);
        const bool is_of_house = kind == StickFileKind::bundle || kind == StickFileKind::house_key;
        if (is_of_house == are_of_house) files.push_back(i);
    }
    return files;
}

std::vector<std::string> OperatorSession::stick_names(bool are_of_house) const {
    std::vector<std::string> names;
    for (const std::size_t file : stick_files(are_of_house)) names.push_back(stick_.names()[file]);
    return names;
}

std::vector<OperatorEvent> OperatorSession::poll_house() {
    auto news = house_.poll();
    if (!is_inside()) house_.forget();
    if (!news) return {};
    if (news->has_changed) has_new_site_ = true;
    std::vector<OperatorEvent> events;
    if (news->place) events.emplace_back(HouseLooked{*news->place});
    const std::string said = told(std::move(news->outcome));
    if (!said.empty()) events.emplace_back(OrderAnswered{plain_line(said)});
    return events;
}

std::optional<std::string> OperatorSession::poll_stick(const Language& language) {
    const std::string problem = stick_.poll();
    if (!problem.empty())
        return told({told_of_file(problem, stick_trouble, language, ToldTo::staff), problem});
    const bool has_ended =
        import_.valid() && import_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!has_ended) return std::nullopt;
    return told(import_.get());
}

void OperatorSession::count_picture(PictureSource source, std::chrono::sys_days today) {
    if (!settings_.counts) return;
    Counts& counts = counts_on(today, days_);
    if (source == PictureSource::gallery) ++counts.gallery_pictures;
    if (source == PictureSource::stick) ++counts.stick_pictures;
    if (source == PictureSource::camera) ++counts.camera_pictures;
}

/// Written once a visit, because a disk wears out.
void OperatorSession::count_visit(double minutes, std::chrono::sys_days today) {
    if (!settings_.counts) return;
    Counts& counts = counts_on(today, days_);
    ++counts.visits;
    counts.minutes += static_cast<std::uint64_t>(std::max(0.0, std::round(minutes)));
    keep_counts();
}

/// Written at once, for what is faulty may end the kiosk too; and once a second at most: a plug
/// that is loose is many faults.
void OperatorSession::count_faults(std::uint64_t began, std::chrono::sys_days today, double now_s) {
    constexpr double between_s = 1.0;
    if (began > 0) {
        counts_on(today, days_).faults += began;
        is_fault_unkept_ = true;
    }
    if (!is_fault_unkept_ || now_s - fault_kept_s_ < between_s) return;
    is_fault_unkept_ = false;
    fault_kept_s_ = now_s;
    keep_counts();
}

void OperatorSession::keep_counts() {
    const auto kept = keep_counters(files_.counters, days_);
    if (!kept && can_keep_) note_ = kept.error().line;
    can_keep_ = kept.has_value();
}

bool OperatorSession::can_write() const {
    const fs::path probe = files_.counters.parent_path() / "write-test";
    std::error_code error;
    fs::create_directories(probe.parent_path(), error);
    std::ofstream file(probe);
    file << "touchline";
    file.close();
    return file.good() && fs::remove(probe, error);
}

void OperatorSession::log(const std::string& line) {
    log_.push_back(line);
    if (log_.size() > longest_log) log_.erase(log_.begin());
}

}  // namespace touchline
