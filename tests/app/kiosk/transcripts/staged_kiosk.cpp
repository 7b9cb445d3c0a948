#include "tests/app/kiosk/transcripts/staged_kiosk.h"

#include "app/documents/trace/finding_things.h"
#include "app/force/device/device_words.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/kiosk/loading/stages.h"
#include "app/visit/keys/key_wizard.h"
#include "config/settings/settings_text.h"
#include "tests/machines/sim/kiosk/due_jobs.h"
#include "tests/machines/sim/kiosk/house.h"
#include "vision/camera/camera.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr double frame_s = 1.0 / 60.0;
constexpr double load_s = 0.6;  // each load job
constexpr double quickly_s = 0.4;
constexpr double to_a_place_s = 8.0;  // moving the hand while the device is homed
constexpr double listing_s = 1.0;     // listing a stick
constexpr double pace_m_per_s = 0.04;
constexpr double after_a_pause_s = 2.0;  // by then, what is said to a waiting visitor has begun
constexpr double longest_s = 120.0;      // any wait

constexpr std::array<const char*, key_role_count> key_names{"Up",     "Down", "Back",   "Repeat",
                                                            "Select", "Help", "Louder", "Softer"};

fs::path new_folder() {
    static std::atomic<int> count{0};
    const std::string name = fmt::format("touchline-transcripts-{}-{}", getpid(), ++count);
    const fs::path folder = fs::temp_directory_path() / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

std::unique_ptr<OperatorSession> desk_of(const fs::path& folder, const Staging& staging,
                                         const std::vector<Language>& languages) {
    const OperatorFiles files = site_files_in(folder);
    Settings settings;
    settings.first_language = staging.language;
    settings.two_switches = staging.two_switches;
    settings.offers_drawing = staging.offers_drawing;
    if (staging.has_printer) settings.printer = "sheets";
    // Without settings there is no file.
    const std::string text = settings_text(settings, Settings{});
    if (!text.empty()) std::ofstream(files.settings.site) << text;
    std::vector<std::string> problems;
    auto desk = std::make_unique<OperatorSession>(files, languages, problems);
    if (!problems.empty()) throw std::runtime_error(problems.front());
    return desk;
}

constexpr double still_s = 0.7;

/// A dark disc with light and grain everywhere, as no program paints it.
CameraFrame photograph() {
    constexpr int width = 420;
    constexpr int height = 300;
    CameraFrame frame;
    frame.size = {width, height};
    frame.stride_bytes = std::size_t{3} * width;
    std::uint32_t random = 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            random = random * 1664525U + 1013904223U;
            const double grain = static_cast<double>(random >> 24U) / 16.0 - 8.0;
            const double light = 30.0 * std::sin(x / 17.0) * std::cos(y / 23.0);
            const double ground = std::hypot(x - 210, y - 150) < 70.0 ? 70.0 : 170.0;
            const double value = ground + light + 15.0 * std::sin((x + 2.0 * y) / 41.0) + grain;
            frame.bytes.insert(frame.bytes.end(), 3, static_cast<std::uint8_t>(value));
        }
    }
    return frame;
}

MainThings dog() {
    constexpr int cells = 40;
    const ThingBox box{0.33, 0.26, 0.67, 0.74};
    MainThings things;
    things.is_sure = true;
    things.boxes = {box};
    things.names = {{ThingName::dog, box, 0.9}};
    things.mask = {cells, cells, std::vector<std::uint8_t>(std::size_t{cells} * cells, 0)};
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            if (std::hypot((x - 19.5) / cells / 0.17, (y - 19.5) / cells / 0.24) < 1.0)
                things.mask.grey[static_cast<std::size_t>(cells * y + x)] = 255;
    return things;
}

/// The lines of a gallery picture, without its words.
Page page_without_words(std::size_t picture, int number, int count) {
    Page page = gallery_without_workers().files[0][picture]->open({}).value();
    page.told.title.clear();
    page.told.description.clear();
    page.told.labels.clear();
    for (Outline& outline : page.told.outlines) outline.label.clear();
    page.number = number;
    page.count = count;
    return page;
}

Result<Page> open_document(const PageOrder& order) {
    constexpr std::array<std::size_t, 3> drawn{5, 12, 34};  // a fish, a boat, a graph
    constexpr int count = 12;
    if (order.page < 1 || order.page > count) return failure("plan.pdf has no such page");
    const auto picture = static_cast<std::size_t>(order.page - 1) % drawn.size();
    return page_without_words(drawn.at(picture), order.page, count);
}

FilePtr file_of_stick(const std::string& name, std::function<Result<Page>(const PageOrder&)> open) {
    return std::make_shared<const PictureFile>(
        PictureFile{name, name, "", true, std::move(open), name});
}

/// A camera above a photograph of a dark, round thing. It can be unplugged.
class StagedCamera final : public Camera {
  public:
    [[nodiscard]] std::vector<CameraName> list() override { return {}; }

    void choose(const std::string& /*id*/) override {}

    [[nodiscard]] std::optional<CameraAbilities> abilities() const override { return std::nullopt; }

    void want_still() override { is_wanted_ = true; }

    [[nodiscard]] CameraView step(double now_s) override;

  private:
    bool is_wanted_ = false;
    std::optional<double> due_s_;
};

CameraView StagedCamera::step(double now_s) {
    CameraView view;
    view.condition = CameraCondition::ready;
    if (!is_wanted_) return view;
    if (!due_s_) due_s_ = now_s + still_s;
    if (now_s < *due_s_) return view;
    view.still = Still{photograph(), {}, false, false};
    is_wanted_ = false;
    due_s_.reset();
    return view;
}

/// Takes the thing in the middle for a dog, and finds nothing anywhere else.
ThingFinder staged_finder() {
    return [](const Page& page,
              const std::optional<PlaceInPicture>& place) -> Result<std::optional<Page>> {
        if (place) return std::nullopt;
        Page seen = with_main_things(page, dog());
        seen.was_searched = true;
        return seen;
    };
}

/// A document of twelve pages, and a file that is no document.
std::vector<FilePtr> staged_files() {
    return {file_of_stick("holiday plan.pdf", open_document),
            file_of_stick("ticket.pdf", [](const PageOrder&) -> Result<Page> {
                return failure("ticket.pdf is no picture that is known here, by its first bytes");
            })};
}

std::vector<FilePtr> two_hundred_and_five_files() {
    const std::size_t drawn = gallery_without_workers().files[0].size();
    std::vector<FilePtr> files;
    const auto add = [&](const std::string& name) {
        files.push_back(file_of_stick(name, [place = files.size() % drawn](const PageOrder&) {
            return Result<Page>(page_without_words(place, 1, 1));
        }));
    };
    for (const char* name : {"Anna", "boat", "cat", "garden", "house", "map"})
        for (int i = 1; i <= 10; ++i) add(fmt::format("{} {}.png", name, i));
    for (int i = 1; i <= 135; ++i) add(fmt::format("P{}.JPG", 1000 + i));
    for (int i = 1; i <= 10; ++i) add(fmt::format("zoo {}.png", i));
    return files;
}

}  // namespace

/// Takes its time for each sheet.
class StagedPrinter final : public SitePrinter {
  public:
    void print(TactileMap /*map*/, PrintOrder /*order*/) override { is_begun_ = true; }

    [[nodiscard]] std::optional<PrintEnd> step(const std::string& /*queue*/, double now_s,
                                               bool /*is_watched*/) override {
        constexpr double print_s = 15.0;
        if (std::exchange(is_begun_, false)) due_s_ = now_s + print_s;
        if (!due_s_ || now_s < *due_s_) return std::nullopt;
        due_s_.reset();
        return has_paper ? PrintEnd::printed : PrintEnd::no_paper;
    }

    [[nodiscard]] std::optional<PrintEnd> condition() const override { return PrintEnd::printed; }

    bool has_paper = true;

  private:
    bool is_begun_ = false;
    std::optional<double> due_s_;
};

StagedKiosk::StagedKiosk(const Staging& staging)
    : switches_(staging.two_switches), folder_(new_folder()) {
    auto servo = std::make_unique<SteppedServo>();
    servo_ = servo.get();
    auto sticks = std::make_unique<SimFileSource>();
    sticks_ = sticks.get();
    KioskParts parts;
    parts.languages = all_languages();
    parts.gallery = gallery_without_workers();
    parts.servo = std::move(servo);
    parts.sound = std::make_unique<TimedVoice>(hearing_);
    parts.profile = default_profile();
    parts.loader = std::make_unique<Loader>(
        std::make_shared<const KioskStages>(parts.profile, PageReader(), staged_finder()),
        std::make_unique<DueJobs>(now_s_, [] {
            return JobFate{load_s, {}};
        }));
    parts.sticks = std::move(sticks);
    if (staging.has_printer) {
        auto printer = std::make_unique<StagedPrinter>();
        printer_ = printer.get();
        parts.printer = std::move(printer);
    }
    parts.photos = std::make_unique<PhotoCapture>(std::make_unique<StagedCamera>());
    parts.operator_session = desk_of(folder_, staging, parts.languages);
    parts.settings = parts.operator_session->settings();
    parts.keys = parts.operator_session->keys();
    parts.minute_of_day = [] { return 12 * 60; };
    kiosk_ = std::make_unique<Kiosk>(std::move(parts));
    run(1.0);
}

StagedKiosk::~StagedKiosk() {
    kiosk_.reset();
    fs::remove_all(folder_);
}

void StagedKiosk::run(double for_s) {
    const double end_s = now_s_ + for_s;
    while (now_s_ < end_s) {
        now_s_ += frame_s;
        hearing_->now_s = now_s_;
        servo_->run_until(now_s_);
        // The hand yields while it is led.
        const GuidancePhase phase = kiosk_->hand().guidance.phase;
        if (phase == GuidancePhase::running || phase == GuidancePhase::pausing)
            servo_->hand().move_to(servo_->handle_W());
        kiosk_->step(static_cast<std::int64_t>(1e9 * now_s_));
    }
}

void StagedKiosk::tell(const std::string& direction) {
    hearing_->transcript.push_back({now_s_, now_s_, "", direction, false, false});
}

void StagedKiosk::press(KeyRole role) {
    const bool is_select = role == KeyRole::select;
    const bool has_two = switches_ == SwitchUse::move_and_select;
    tell(switches_ == SwitchUse::by_itself ? "the switch"
         : !has_two                        ? key_names.at(static_cast<std::size_t>(role))
         : is_select                       ? "the switch that selects"
                                           : "the switch that moves on");
    hearing_->key_s = now_s_;
    kiosk_->press(role);
    run(frame_s);
}

void StagedKiosk::press_quickly(KeyRole role) {
    press(role);
    run(quickly_s);
}

void StagedKiosk::do_nothing(double for_s) {
    tell(fmt::format("does nothing for {:.0f} seconds", for_s));
    run(for_s);
}

void StagedKiosk::put(std::vector<FilePtr> files) {
    tell("puts a USB stick in");
    sticks_->put(std::move(files), listing_s);
    run(listing_s);
    listen();
}

void StagedKiosk::put_stick() {
    put(staged_files());
}

void StagedKiosk::put_full_stick() {
    put(two_hundred_and_five_files());
}

void StagedKiosk::pull_stick() {
    tell("pulls the USB stick out");
    sticks_->pull();
    listen();
}

void StagedKiosk::empty_printer() {
    tell("the printer has run out of paper");
    printer_->has_paper = false;
}

void StagedKiosk::break_device() {
    tell("the board of the handle loses its power");
    servo_->break_device(true);
    listen();
}

void StagedKiosk::home_to(HomingStep step, const std::string& direction) {
    tell(direction);
    HomingView view;
    view.step = step;
    servo_->words = step == HomingStep::done ? "" : words_of(view, default_profile());
    listen();
}

void StagedKiosk::home_device() {
    servo_->break_device(false);
    home_to(HomingStep::to_home, "the board has power again");
    run(to_a_place_s);
    home_to(HomingStep::to_check, "moves the handle to the first place");
    run(to_a_place_s);
    home_to(HomingStep::done, "moves the handle to the second place");
}

void StagedKiosk::move_to(Position to) {
    const Position from = servo_->handle_W();
    const int frames = 1 + static_cast<int>(norm(to - from) / (pace_m_per_s * frame_s));
    for (int i = 1; i <= frames; ++i) {
        servo_->hand().move_to(from + (static_cast<double>(i) / frames) * (to - from));
        run(frame_s);
    }
}

void StagedKiosk::follow_a_line(double for_s) {
    tell("moves the handle along a line");
    const std::vector<Position> points = servo_->picture().map->outlines.at(0).points;
    move_to(points.front());
    const double end_s = now_s_ + for_s;
    for (std::size_t i = 1; now_s_ < end_s; ++i) move_to(points[i % points.size()]);
}

void StagedKiosk::draw_line(Position from, Position to) {
    constexpr int steps = 60;
    tell("somebody draws a line");
    kiosk_->change_pen({PenMotion::press, from});
    for (int i = 1; i <= steps; ++i) {
        run(1.0 / steps);
        const Position at = from + (static_cast<double>(i) / steps) * (to - from);
        kiosk_->change_pen({PenMotion::move, at});
    }
    kiosk_->change_pen({PenMotion::lift, to});
}

void StagedKiosk::erase_at(Position place) {
    tell("somebody erases a line");
    kiosk_->change_pen({PenMotion::press, place, true});
}

void StagedKiosk::listen() {
    const double end_s = now_s_ + longest_s;
    double quiet_since_s = now_s_;
    while (now_s_ < end_s && now_s_ - quiet_since_s < after_a_pause_s) {
        run(frame_s);
        if (hearing_->is_speaking) quiet_since_s = now_s_;
    }
}

void StagedKiosk::hear_one_thing() {
    const int ended = hearing_->ended;
    const double end_s = now_s_ + longest_s;
    while (hearing_->is_speaking && hearing_->ended == ended && now_s_ < end_s) run(frame_s);
    run(frame_s);
}

void StagedKiosk::go_to(int id) {
    const auto is_it = [id](const ScreenItem& item) { return item.id == id; };
    if (std::ranges::none_of(screen().items, is_it))
        throw std::runtime_error(fmt::format("no item {} on the screen {}", id, screen().title));
    for (SpokenScreen shown = screen(); !is_it(shown.items.at(*shown.focus)); shown = screen()) {
        press(KeyRole::down);
        hear_one_thing();
    }
}

void StagedKiosk::choose(int id) {
    go_to(id);
    press(KeyRole::select);
    listen();
}

void StagedKiosk::choose(OperatorItem item, std::size_t index) {
    for (const ScreenItem& shown : screen().items) {
        const ItemMeaning meaning = meaning_of(shown);
        if (meaning.item == item && meaning.index == index) return choose(shown.id);
    }
    throw std::runtime_error("no such item on the screen " + screen().title);
}

void StagedKiosk::choose_key(KeyRole role) {
    const std::string name = role_in_words(role, kiosk_->language());
    const auto is_said = [&] { return kiosk_->caption() == name; };
    const double end_s = now_s_ + longest_s;
    while (!is_said() && now_s_ < end_s) {
        press(KeyRole::down);
        hear_one_thing();
    }
    if (!is_said()) throw std::runtime_error(fmt::format("{} does not come", name));
    press(KeyRole::select);
    listen();
}

void StagedKiosk::choose_when_it_comes(int id) {
    const auto has_come = [this, id] {
        const SpokenScreen shown = screen();
        return shown.focus && shown.items.at(*shown.focus).id == id;
    };
    const double end_s = now_s_ + longest_s;
    while ((!has_come() || hearing_->is_speaking) && now_s_ < end_s) run(frame_s);
    if (!has_come())
        throw std::runtime_error(fmt::format("item {} does not come on {}", id, screen().title));
    run(quickly_s);
    press(KeyRole::select);
    hear_one_thing();
}

void StagedKiosk::wait_for(VisitScreen screen) {
    const double end_s = now_s_ + longest_s;
    while (open_screen(kiosk_->visit()) != screen && now_s_ < end_s) run(frame_s);
    listen();
}

}  // namespace touchline
