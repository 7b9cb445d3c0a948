#include "app/main/kiosk_window.h"

#include "app/braille/braille_line.h"
#include "app/documents/gallery/gallery.h"
#include "app/documents/packs/pack_library.h"
#include "app/documents/sticks/stick_port.h"
#include "app/isolation/process/places.h"
#include "app/kiosk/kiosk.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/kiosk/loading/loader.h"
#include "app/kiosk/stick_source.h"
#include "app/main/life_signs.h"
#include "app/screen/kiosk_screen.h"
#include "app/screen/pace.h"
#include "app/screen/screen_content.h"
#include "app/screen/window.h"
#include "app/sound/sound.h"
#include "app/visit/keys/operator_keyboard.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace touchline {

namespace {

constexpr int frame_rate_Hz = 60;
constexpr int waiting_rate_Hz = 20;  // while nobody is here; a key is heard at once all the same
constexpr std::int64_t second_ns = 1'000'000'000;
constexpr std::size_t loading_threads = PlanLimits{}.jobs;

std::atomic<bool> is_end_asked{false};

constexpr unsigned longest_end_s = 3;  // a servo fades out and ends in two

/// Asks for the end, and exits if anything hangs by then: the servo zeroes the torque when its
/// kiosk dies.
void ask_for_end(int) {
    is_end_asked = true;
    (void)alarm(longest_end_s);
}

void end_at_once(int) {
    constexpr std::string_view line = "touchline: something hangs: ended without waiting for it\n";
    (void)!write(STDERR_FILENO, line.data(), line.size());
    _exit(1);
}

void report(const std::string& line) {
    if (!line.empty()) fmt::print(stderr, "touchline: {}\n", plain_line(line));
}

/// The languages that the operator offers, in that order; English if none of them exists.
std::vector<Language> offered(std::vector<Language> languages, const std::string& codes) {
    std::vector<Language> chosen;
    std::istringstream words(codes);
    for (std::string code; words >> code;) {
        const auto at = std::ranges::find(languages, code, &Language::code);
        if (at != languages.end()) {
            chosen.push_back(*at);
        } else {
            report("settings: there are no words of '" + code + "'; take it out of the languages");
        }
    }
    if (chosen.empty()) chosen.emplace_back();
    return chosen;
}

/// What the staff's live view shows now; nothing: it is off.
std::optional<LiveContent> live_content_of(const Kiosk& kiosk, ServoClient& servo) {
    const Kiosk::WindowWishes& wishes = kiosk.window_wishes();
    if (!wishes.shows_live_view) return std::nullopt;
    return LiveContent{describe(kiosk.live_facts(), kiosk.hand(), kiosk.force(), kiosk.language()),
                       wishes.shows_boxes, servo.lateness()};
}

/// What the kiosk's screen shows now. O(items of the screen).
ScreenContent content_of(const Kiosk& kiosk, ServoClient& servo) {
    const Visitor& visitor = kiosk.visit().visitor;
    const DrawnPicture drawn = kiosk.drawn();
    ScreenContent content;
    content.screen = kiosk.screen();
    content.pictures = kiosk.pictures_of(content.screen);
    content.caption = kiosk.caption();
    content.sound_sign = kiosk.sound_sign();
    content.text_size = static_cast<TextSize>(visitor.look.text_size);
    content.palette = static_cast<PaletteName>(visitor.look.palette);
    content.is_curtain = visitor.look.is_off && !kiosk.is_operator_in();
    content.preview = kiosk.preview();
    content.is_preview_on = content.preview != nullptr;
    content.hand = drawn.hand;
    content.shown = drawn.shown;
    content.stroke = kiosk.pen().line();
    content.language = kiosk.language();
    content.switches = kiosk.switches();
    content.live = live_content_of(kiosk, servo);
    return content;
}

/// The servo's counts up to a moment.
struct ServoCount {
    std::uint64_t ticks = 0;
    std::uint64_t missed = 0;
};

/// The kiosk in its window, in real time.
class KioskWindow {
  public:
    KioskWindow(const KioskArguments& arguments, const ServoStarter& start)
        : arguments_(arguments), start_servo_(start) {}

    Result<void> run() {
        auto opened = open_window().and_then([this] { return open_kiosk(); });
        if (!opened) return opened;
        run_frames();
        draw_end();
        if (arguments_.measure_s && !is_end_asked) measure_without_window();
        signs_.end();
        kiosk_->stop();
        return {};
    }

  private:
    static std::tm local_time() {
        const std::time_t now = std::time(nullptr);
        std::tm local{};
        localtime_r(&now, &local);
        return local;
    }

    static int minute_of_day() {
        const std::tm local = local_time();
        return 60 * local.tm_hour + local.tm_min;
    }

    static std::chrono::sys_days today() {
        const std::tm local = local_time();
        return std::chrono::year(1900 + local.tm_year) /
               std::chrono::month(static_cast<unsigned>(1 + local.tm_mon)) /
               std::chrono::day(static_cast<unsigned>(local.tm_mday));
    }

    Result<void> open_window() {
        std::vector<std::string> problems;
        sound_ = sound_parts();
        operator_ = std::make_unique<OperatorSession>(operator_files(), sound_.languages, problems);
        settings_ = operator_->settings();
        for (const std::string& problem : sound_.problems) report(problem);
        for (const std::string& problem : problems) report(problem);
        auto window = Window::open(!arguments_.in_window,
                                   {[this](const PhysicalKey& key, bool is_down, bool is_repeat) {
                                        kiosk_->change_key({key, is_down, is_repeat,
                                                            1e-9 * static_cast<double>(now_ns())});
                                    },
                                    [this](PixelPoint place) { move_pointer(place); },
                                    [this](const PointerPress& press) { press_pen(press); },
                                    [this](double by_rad) {
                                        if (kiosk_) kiosk_->turn_knob(by_rad);
                                    }});
        if (!window) return tl::unexpected(window.error());
        window_ = std::move(*window);
        return make_screen();
    }

    Result<void> make_screen() {
        cap_px_ = cap_height_px(settings_.viewing_distance_m, mm_per_px());
        auto screen = KioskScreen::make(cap_px_);
        if (!screen) return tl::unexpected(screen.error());
        screen_ = std::make_unique<KioskScreen>(std::move(*screen));
        width_px_ = window_->width_px();
        height_px_ = window_->height_px();
        return {};
    }

    /// Another screen mode has pixels of another size, so the letters are remade to look as large.
    void follow_pixels() {
        const bool is_same = width_px_ == window_->width_px() && height_px_ == window_->height_px();
        if (arguments_.in_window || is_same) return;
        width_px_ = window_->width_px();
        height_px_ = window_->height_px();
        if (cap_px_ == cap_height_px(settings_.viewing_distance_m, mm_per_px())) return;
        if (const auto made = make_screen(); !made) report(made.error().line);
    }

    /// The operator's measure of the screen, else the monitor's own.
    [[nodiscard]] double mm_per_px() const {
        if (settings_.screen_inches <= 0.0) return window_->mm_per_px();
        return 25.4 * settings_.screen_inches /
               std::hypot(window_->width_px(), window_->height_px());
    }

    Result<void> open_kiosk() {
        auto servo = start_servo_(hand_, settings_);
        if (!servo) return tl::unexpected(servo.error());
        report(servo->note);
        sound_.languages = offered(std::move(sound_.languages), settings_.languages);
        const std::string& tried = arguments_.tried_library;
        auto gallery =
            read_gallery(gallery_folder(), tried.empty() ? library_folder() : tried,
                         sound_.languages, tried.empty() ? Offered::all : Offered::packs);
        if (!gallery) return tl::unexpected(gallery.error());

        KioskParts parts;
        parts.languages = sound_.languages;
        parts.gallery = std::move(*gallery);
        parts.settings = settings_;
        parts.keys = operator_->keys();
        parts.minute_of_day = minute_of_day;
        parts.today = today;
        parts.operator_session = std::move(operator_);
        parts.are_keys_free = arguments_.in_window;
        parts.profile = servo->profile;
        parts.hand_words = servo->hand_words;
        parts.hand_name = servo->hand_name;
        parts.reading_language = std::make_shared<std::atomic<WrittenLanguage>>();
        parts.loader = std::make_unique<Loader>(
            std::make_shared<const KioskStages>(servo->profile, page_reader(parts.reading_language),
                                                thing_finder()),
            std::make_unique<ThreadExecutor>(loading_threads));
        parts.sound = std::make_unique<Sound>(
            std::move(sound_), [client = servo->client.get()] { return client->next_event(); });
        parts.braille = std::make_unique<BrailleLine>(settings_.braille);
        parts.sticks = std::make_unique<StickSource>(open_stick_port(settings_.watched_folder),
                                                     companion("touchline-import"));
        parts.photos = open_photos();
        parts.printer = std::make_unique<SheetPrinter>(printing_by(
            {companion("touchline-sheet"), companion("touchline-print"), words_folder().string()}));
        servo_ = servo->client.get();
        has_motors_ = servo->has_motors;
        parts.servo = std::move(servo->client);
        kiosk_ = std::make_unique<Kiosk>(std::move(parts));
        offer_files();
        return {};
    }

    /// Without libcamera the kiosk has no camera, and its screens say so.
    static std::unique_ptr<PhotoCapture> open_photos() {
        auto camera = open_camera();
        if (camera) return std::make_unique<PhotoCapture>(std::move(*camera));
        report(camera.error().line);
        return nullptr;
    }

    void offer_files() {
        std::vector<std::string> problems;
        auto files = files_at(arguments_.files, companion("touchline-import"), problems);
        for (const std::string& problem : problems) report(problem);
        if (!files.empty()) kiosk_->give(std::move(files));
    }

    /// Draws while the pen is down; then the hand stays where it is.
    void move_pointer(PixelPoint place) {
        if (!screen_ || !kiosk_) return;
        const Position p = screen_->view().to_W(place);
        if (!kiosk_->pen().is_down()) return lead_hand(p);
        kiosk_->change_pen({PenMotion::move, p});
    }

    void press_pen(const PointerPress& press) {
        if (!screen_ || !kiosk_) return;
        if (press.is_down && !screen_->shows_picture()) return;
        const PenMotion motion = press.is_down ? PenMotion::press : PenMotion::lift;
        kiosk_->change_pen({motion, screen_->view().to_W(press.place), press.is_second});
    }

    /// The hand means to be where the pointer is, inside the drawing area.
    void lead_hand(Position p) {
        const ShownScene& shown = kiosk_->shown();
        const Area area = shown.scene ? shown.scene->area : Area{};
        pointer_ = {std::clamp(p.x, -area.width_m / 2.0, area.width_m / 2.0),
                    std::clamp(p.y, -area.height_m / 2.0, area.height_m / 2.0)};
    }

    /// The settings may name another keyboard while the kiosk runs.
    void follow_operator_device() {
        if (kiosk_->operator_device() == operator_device_) return;
        operator_device_ = kiosk_->operator_device();
        operator_keyboard_ = OperatorKeyboard(operator_device_);
        report(operator_keyboard_.problem());
    }

    void report_news() {
        std::istringstream lines(kiosk_->take_report());
        for (std::string line; std::getline(lines, line);) report(line);
        const std::optional<RealTimeTier> tier = servo_->tier();
        if (!has_motors_ || !tier || tier == told_tier_) return;
        report(fmt::format("timing: {}", describe(*tier)));
        told_tier_ = tier;
    }

    void draw(std::int64_t time_ns) {
        follow_pixels();
        const int width = window_->width_px();
        const int height = window_->height_px();
        if (window_->take_exposed()) screen_->lose_frame();
        if (screen_->draw(content_of(*kiosk_, *servo_), width, height, time_ns))
            window_->show_frame();
    }

    /// The last frame stays on a screen with nothing behind it, and must not look broken.
    void draw_end() {
        const Language& language = kiosk_->language();
        ScreenContent content;
        content.screen.title = language.text("visit", "This kiosk is closed.");
        content.screen.text = language.text("visit", "Please come back later.");
        content.language = language;
        content.has_ended = true;
        if (!make_screen())
            return;  // its layers have no change behind them: this one shows at once
        (void)screen_->draw(content, width_px_, height_px_, now_ns());
        window_->show_frame();
    }

    [[nodiscard]] bool goes_on(std::int64_t time_ns, std::int64_t start_ns) const {
        if (kiosk_->window_wishes().is_quitting || is_end_asked || window_->is_closing())
            return false;
        return !arguments_.measure_s ||
               static_cast<double>(time_ns - start_ns) < *arguments_.measure_s * 1e9;
    }

    void run_frames() {
        const std::int64_t start_ns = now_ns();
        const ServoCount before = count();
        FrameLimiter limiter(start_ns, frame_rate_Hz);
        std::int64_t time_ns = start_ns;
        for (; goes_on(time_ns, start_ns); time_ns = now_ns()) {
            const int rate_Hz = kiosk_->is_nobody_here() ? waiting_rate_Hz : frame_rate_Hz;
            led_ = paced(led_, pointer_, 1.0 / rate_Hz);
            hand_->move_to(led_);
            follow_operator_device();
            for (const PhysicalKey& key : operator_keyboard_.take_presses())
                kiosk_->strike_operator_key(key);
            kiosk_->step(time_ns);
            window_->show_pointer(kiosk_->takes_pen());
            report_news();
            draw(time_ns);
            signs_.beat(time_ns, servo_->beats());
            const std::int64_t due_ns = limiter.finish_frame(now_ns());
            window_->wait_until(due_ns + second_ns / rate_Hz - second_ns / frame_rate_Hz);
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
            (void)servo_->latest();  // a kiosk that does not ask its servo counts as dead
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        fmt::print("{}\n", counted("without the window", now_ns() - start_ns, before));
    }

    [[nodiscard]] ServoCount count() {
        const HandState& hand = servo_->latest();
        return {hand.ticks, hand.missed_ticks};
    }

    std::string counted(const char* name, std::int64_t elapsed_ns, const ServoCount& before) {
        const ServoCount after = count();
        return fmt::format("{}: {:.2f} s, {} ticks, {} missed", name,
                           static_cast<double>(elapsed_ns) * 1e-9, after.ticks - before.ticks,
                           after.missed - before.missed);
    }

    KioskArguments arguments_;
    ServoStarter start_servo_;
    SoundParts sound_;                           // until the kiosk takes them
    std::unique_ptr<OperatorSession> operator_;  // likewise
    Settings settings_;                          // at the start
    std::string operator_device_;
    OperatorKeyboard operator_keyboard_;
    LifeSigns signs_;
    Position pointer_;  // where the pointer is
    Position led_;      // where the hand means to be
    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    bool has_motors_ = false;
    std::optional<RealTimeTier> told_tier_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<KioskScreen> screen_;  // dies before the window that has its OpenGL context
    double cap_px_ = 0.0;                  // of its letters
    int width_px_ = 0;                     // of the window, when the letters were chosen
    int height_px_ = 0;
    std::unique_ptr<Kiosk> kiosk_;
    ServoClient* servo_ = nullptr;  // the kiosk's
};

}  // namespace

int run_kiosk(const KioskArguments& arguments, const ServoStarter& start) {
    is_end_asked = false;
    std::signal(SIGALRM, end_at_once);
    std::signal(SIGINT, ask_for_end);
    std::signal(SIGTERM, ask_for_end);
    const Result<void> done = KioskWindow(arguments, start).run();
    if (done) return 0;
    report(done.error().line);
    return 1;
}

void forbid_core_dumps() {
    const rlimit none{0, 0};
    // The system never refuses to lower a limit or give up a right.
    (void)setrlimit(RLIMIT_CORE, &none);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);
}

}  // namespace touchline
