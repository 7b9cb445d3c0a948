#include "app/main/kiosk.h"

#include "app/gallery/gallery.h"
#include "app/loading/kiosk_stages.h"
#include "app/loading/loader.h"
#include "app/loading/page_reader.h"
#include "app/loading/thread_executor.h"
#include "app/main/kiosk_servo.h"
#include "app/main/picture_list.h"
#include "app/main/pointer_pace.h"
#include "app/main/stick_shelf.h"
#include "app/operator/settings_files.h"
#include "app/process/places.h"
#include "app/screen/frame_limiter.h"
#include "app/screen/kiosk_screen.h"
#include "app/screen/window.h"
#include "app/session/session.h"
#include "app/session/status.h"
#include "app/sound/sound.h"
#include "app/sticks/open_stick_port.h"
#include "haptics/servo/loop_settings.h"
#include "haptics/servo/servo.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace touchline {

namespace {

constexpr int frame_rate_Hz = 60;
constexpr std::int64_t settings_look_ns = 1'000'000'000;
constexpr std::size_t loading_threads = PlanLimits{}.jobs;
constexpr std::int64_t patience_ns = 5'000'000'000;  // until sticks are missed

std::atomic<bool> is_end_asked{false};

void ask_for_end(int) {
    is_end_asked = true;
}

void report(const std::string& line) {
    fmt::print(stderr, "touchline: {}\n", line);
}

/// The files that were named, then the gallery. Without one the kiosk still shows the files.
std::vector<FilePtr> files_to_show(const std::vector<std::string>& named) {
    std::vector<FilePtr> files;
    for (const std::string& path : named) files.push_back(file_at(path));
    const auto gallery = list_gallery(gallery_folder());
    if (!gallery) {
        report(gallery.error().line);
        return files;
    }
    for (const GalleryEntry& entry : *gallery) files.push_back(file_at(entry.path));
    return files;
}

/// What the servo counted up to a moment.
struct ServoCount {
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
};

class Kiosk {
  public:
    explicit Kiosk(const KioskArguments& arguments)
        : arguments_(arguments), list_(files_to_show(arguments.files)) {
        read_settings_again();
    }

    Result<void> run() {
        auto opened = open();
        if (!opened) return opened;
        const LoopSettings loop = loop_settings(default_profile(), ServoOptions{}.period_s, 0.0);
        carry_out(start_session(list_.size(), loop.stiffness_N_per_m, settings_));
        run_frames();
        if (arguments_.measure_s && !is_end_asked) measure_without_window();
        sound_.reset();  // it reads the servo's events
        shelf_->end_session();
        servo_.client->stop();
        return {};
    }

  private:
    Result<void> open() {
        auto window = Window::open(
            !arguments_.in_window,
            {[this](Key key) { press(key); }, [this](PixelPoint place) { lead_hand(place); }});
        if (!window) return tl::unexpected(window.error());
        window_ = std::move(*window);
        auto screen =
            KioskScreen::make(cap_height_px(settings_.viewing_distance_m, window_->mm_per_px()));
        if (!screen) return tl::unexpected(screen.error());
        screen_ = std::make_unique<KioskScreen>(std::move(*screen));
        auto servo = start_servo(hand_);
        if (!servo) return tl::unexpected(servo.error());
        servo_ = std::move(*servo);
        if (!servo_.note.empty()) report(servo_.note);
        start_sound();
        loader_ = std::make_unique<Loader>(
            std::make_shared<const KioskStages>(servo_.profile, page_reader(spoken_)),
            std::make_unique<ThreadExecutor>(loading_threads));
        shelf_ = std::make_unique<StickShelf>(open_stick_port(settings_.watched_folder),
                                              companion("touchline-import"));
        return {};
    }

    void start_sound() {
        SoundParts parts = sound_parts();
        for (const std::string& problem : parts.problems) report(problem);
        sound_ = std::make_unique<Sound>(
            std::move(parts), [client = servo_.client.get()] { return client->next_event(); });
    }

    void press(Key key) {
        const auto action = action_of(key);
        sound_->key_down(action ? std::optional(action->action) : std::nullopt);
        carry_out(press_key(session_, key, servo_.client->latest().level));
        *spoken_ = written_language(sound_->language().code());
    }

    /// The hand means to be where the pointer is, inside the drawing area.
    void lead_hand(PixelPoint place) {
        if (!screen_) return;
        const Position p = screen_->view().to_W(place);
        const Area area = shown_.scene ? shown_.scene->area : Area{};
        pointer_ = {std::clamp(p.x, -area.width_m / 2.0, area.width_m / 2.0),
                    std::clamp(p.y, -area.height_m / 2.0, area.height_m / 2.0)};
    }

    void carry_out(Step step) {
        session_ = std::move(step.session);
        if (step.commands.load) load();
        if (step.commands.feel) set_servo();
        if (step.commands.home_again) servo_.client->home_again();
        if (step.commands.keep_recording) servo_.client->keep_recording();
        if (step.commands.sound) sound_->carry_out(*step.commands.sound);
        if (step.commands.quit) is_quitting_ = true;
    }

    void set_servo() {
        ServoCommands commands;
        commands.mode = session_.mode;
        commands.stiffness_N_per_m = stiffness_steps[session_.stiffness].stiffness_N_per_m;
        commands.radius_m = proxy_radius_m;
        commands.pop_through_N = session_.is_pop_through ? settings_.give_way_N : 0.0;
        commands.friction = settings_.friction;
        commands.capture_m = settings_.capture_mm / 1000.0;
        commands.finest_level = settings_.finest_level;
        commands.coarsest_level = settings_.coarsest_level;
        commands.is_level_auto = session_.is_level_automatic;
        commands.level = session_.fixed_level;
        commands.is_force_wanted = session_.is_force_wanted;
        commands.is_emergency_stop = session_.is_emergency_stop;
        commands.faults_cleared = session_.faults_cleared;
        servo_.client->set(commands);
    }

    void load() {
        if (session_.is_listed) wanted_ = list_.at(session_.picture);
        const PagePlace& place = session_.place;
        loader_->want(session_.request, {wanted_, place.page, place.view, {session_.detail}});
    }

    void take(Delivery delivery) {
        if (delivery.request != session_.request) return;
        if (!delivery.scene) {
            const std::string& line = delivery.scene.error().line;
            report(wanted_->is_private ? "a file of the stick cannot be felt" : line);
            carry_out(picture_failed(session_, delivery.request, line, delivery.place));
            return;
        }
        const LoadedFacts& facts = delivery.scene->facts;
        if (!facts.note.empty()) report(facts.note);
        shown_ = delivery.scene->shown;
        shown_file_ = wanted_;
        servo_.client->feel(delivery.scene->felt);
        carry_out(picture_ready(session_, delivery.request, facts));
    }

    /// A stick that came is what its owner wants; one that went takes nothing from the hand.
    void put_stick(ShelfChange change) {
        const bool has_come = !change.files.empty();
        list_.put_stick(std::move(change.files));
        carry_out(list_changed(
            session_, {list_.size(), list_.place_of(wanted_), list_.place_of(shown_file_)}));
        if (has_come) carry_out(choose_picture(session_, 0));
        if (!change.sentence.empty()) carry_out(tell(session_, change.sentence));
    }

    void update_pictures(std::int64_t time_ns) {
        for (Delivery& delivery : loader_->poll()) take(std::move(delivery));
        if (auto change = shelf_->poll(time_ns)) put_stick(std::move(*change));
        if (shelf_->is_watching()) watched_ns_ = time_ns;
        if (!misses_sticks_ && time_ns - watched_ns_ > patience_ns) {
            report("USB sticks are not offered: udisks2 does not answer");
            misses_sticks_ = true;
        }
    }

    /// What befell the servo, for the log; its tier is in the panel too.
    void read_settings_again() {
        KeptSettings kept = read_settings(settings_place_);
        if (!kept.note.empty()) report(kept.note);
        settings_ = std::move(kept.settings);
    }

    /// What a hand feels changes at once; what a session begins with, with the next.
    void watch_settings(std::int64_t time_ns) {
        if (time_ns - looked_ns_ < settings_look_ns) return;
        looked_ns_ = time_ns;
        if (!settings_watch_.has_changed()) return;
        read_settings_again();
        set_servo();
    }

    void read_notices() {
        const std::string notice = servo_.client->take_notice();
        if (!notice.empty()) report(notice);
        const std::string words = servo_.client->device_words();
        if (words != told_words_ && !words.empty()) report(words);
        told_words_ = words;
        const RealTimeTier tier = servo_.client->tier();
        if (servo_.has_motors && tier != told_tier_)
            report(fmt::format("timing: {}", describe(tier)));
        told_tier_ = tier;
    }

    void draw(std::int64_t time_ns) {
        read_notices();
        led_ = paced(led_, pointer_, 1.0 / frame_rate_Hz);
        hand_->move_to(led_);
        const HandState& hand = servo_.client->latest();
        const ForceStatus force = servo_.client->force_status();
        sound_->step({{session_, force, told_words_}, hand, shown_.scene.get()});
        const FrameContent content{status(hand, force), session_.shows_keys, session_.shows_boxes,
                                   hand, shown_};
        screen_->draw(content, window_->width_px(), window_->height_px(), time_ns);
        window_->show_frame();
    }

    [[nodiscard]] bool goes_on(std::int64_t time_ns, std::int64_t start_ns) const {
        if (is_quitting_ || is_end_asked || window_->is_closing()) return false;
        return !arguments_.measure_s ||
               static_cast<double>(time_ns - start_ns) < *arguments_.measure_s * 1e9;
    }

    void run_frames() {
        const std::int64_t start_ns = now_ns();
        watched_ns_ = start_ns;
        const ServoCount before = count();
        FrameLimiter limiter(start_ns, frame_rate_Hz);
        std::int64_t time_ns = start_ns;
        for (; goes_on(time_ns, start_ns); time_ns = now_ns()) {
            update_pictures(time_ns);
            watch_settings(time_ns);
            draw(time_ns);
            window_->wait_until(limiter.finish_frame(now_ns()));
        }
        if (arguments_.measure_s) {
            fmt::print("{}, {} frames, {} skipped\n",
                       counted("with the window", time_ns - start_ns, before), limiter.frames(),
                       limiter.skipped());
        }
    }

    void measure_without_window() {
        screen_.reset();
        window_.reset();
        const std::int64_t start_ns = now_ns();
        const ServoCount before = count();
        const auto end =
            std::chrono::steady_clock::now() + std::chrono::duration<double>(*arguments_.measure_s);
        while (std::chrono::steady_clock::now() < end) {
            (void)servo_.client->latest();  // a kiosk that does not look for its servo has died
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        fmt::print("{}\n", counted("without the window", now_ns() - start_ns, before));
    }

    [[nodiscard]] ServoCount count() {
        const HandState& hand = servo_.client->latest();
        return {hand.ticks, hand.missed_ticks};
    }

    std::string counted(const char* name, std::int64_t elapsed_ns, const ServoCount& before) {
        const ServoCount after = count();
        return fmt::format("{}: {:.2f} s, {} ticks, {} missed", name,
                           static_cast<double>(elapsed_ns) * 1e-9, after.ticks - before.ticks,
                           after.missed - before.missed);
    }

    /// What the hand is, and how well its loop is in time: in a word where no force depends on it.
    [[nodiscard]] Status status(const HandState& hand, const ForceStatus& force) {
        Status status = describe(session_, hand, force, hand_words(), sound_->last_event());
        status.lines.push_back({"Sound", sound_->words()});
        if (status.message.empty()) status.message = sound_->problem();
        if (!told_words_.empty() && force.fault == Fault::none) status.message = told_words_;
        return status;
    }

    [[nodiscard]] std::string hand_words() const {
        const std::string_view tier = describe(servo_.client->tier());
        return fmt::format("{}, timing {}", servo_.hand_words,
                           servo_.has_motors ? tier : tier.substr(0, 1));
    }

    KioskArguments arguments_;
    SettingsFiles settings_place_ = settings_files();
    FileWatch settings_watch_{settings_place_.site};
    Settings settings_;
    std::int64_t looked_ns_ = 0;
    PictureList list_;
    FilePtr wanted_;
    FilePtr shown_file_;
    Position pointer_;  // where it is
    Position led_;      // where the hand means to be
    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    KioskServo servo_;
    std::unique_ptr<Sound> sound_;  // dies before the servo whose events it reads
    std::string told_words_;        // to the person at the handle
    RealTimeTier told_tier_ = RealTimeTier::best_effort;
    std::unique_ptr<Window> window_;
    std::unique_ptr<KioskScreen> screen_;  // dies before the window that has its OpenGL context
    Session session_;
    ShownScene shown_;
    /// Words in pictures are read in the language that is spoken.
    std::shared_ptr<std::atomic<WrittenLanguage>> spoken_ =
        std::make_shared<std::atomic<WrittenLanguage>>(WrittenLanguage::english);
    std::unique_ptr<Loader> loader_;
    std::unique_ptr<StickShelf> shelf_;
    std::int64_t watched_ns_ = 0;  // when sticks were last looked for
    bool misses_sticks_ = false;
    bool is_quitting_ = false;
};

}  // namespace

int run_kiosk(const KioskArguments& arguments) {
    is_end_asked = false;
    std::signal(SIGINT, ask_for_end);
    std::signal(SIGTERM, ask_for_end);
    const Result<void> done = Kiosk(arguments).run();
    if (done) return 0;
    report(done.error().line);
    return 1;
}

}  // namespace touchline
