#include "tests/machines/sim/kiosk/sim_house.h"

#include "tests/haptics/tick.h"
#include "tests/machines/sim/kiosk/simulation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr double frame_s = 1.0 / 60.0;
constexpr double beat_s = 1e-3 * guard_beat_ms;
constexpr double sound_s = 4e-3;
constexpr double look_s = 0.05;  // of the servo's main thread, unless something wakes it
constexpr double plan_s = 1e-3;
constexpr double skipped_frame_s = 0.25;
constexpr double quiet_s = 5.0;           // after the last sound; an invitation comes every 11 s
constexpr double before_plan_s = 2.0;     // nothing is skipped so close to a planned event
constexpr double most_jitter_s = 6e-5;    // of a tick's start
constexpr int most_zero_tries = 100;      // by the guard
constexpr double between_tries_s = 0.01;  // by the guard
constexpr std::uint64_t of_schedule = 3;
constexpr std::uint64_t of_printer = 5;

/// Each run has its own folder.
fs::path own_folder() {
    static std::atomic<int> count{0};
    return fs::temp_directory_path() /
           ("touchline-sim-" + std::to_string(getpid()) + "-" + std::to_string(++count));
}

BoardTruth truth_of(const Plan& plan) {
    BoardTruth truth;
    truth.seed = plan.options.seed;
    truth.hand = no_hand;
    return truth;
}

}  // namespace

SimFigures simulate(const Plan& plan, Sabotage sabotage) {
    return SimHouse(plan, sabotage).run();
}

SimHouse::SimHouse(const Plan& plan, Sabotage sabotage)
    : plan_(plan),
      sabotage_(sabotage),
      dice_(Dice::of(plan.options.seed, of_schedule)),
      folder_(own_folder()),
      hand_(std::make_shared<VisitorHand>(default_profile())),
      board_(truth_of(plan), hand_),
      actors_{Actor{&SimHouse::follow_plan, plan_s}, Actor{&SimHouse::frame, frame_s},
              Actor{&SimHouse::guard, beat_s}, Actor{&SimHouse::sound, sound_s},
              Actor{&SimHouse::servo_main, look_s}},
      printer_(now_s_, Dice::of(plan.options.seed, of_printer).next()),
      force_limits_(default_profile()) {
    stored_.is_measured = true;
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "site");
    write_settings();
    if (sabotage == Sabotage::kept_pages) printer_.keep_all();
    // Shuffles who acts first when several are due.
    for (std::size_t i = actors_.size(); i > 2; --i)
        std::swap(actors_[i - 1], actors_[1 + dice_.below(i - 1)]);
    figures_.seeds = 1;
}

SimHouse::~SimHouse() {
    servo_.reset();
    kiosk_.reset();
    fs::remove_all(folder_);
}

SimFigures SimHouse::run() {
    start_kiosk();
    while (!is_over()) {
        const double start_s = now_s_;
        serve_one();
        if (is_over()) break;
        if (is_kiosk_dying_) {
            kiosk_.reset();
            is_kiosk_dying_ = false;
            // The service is started again.
            while (!ongoing_.empty() && !is_over()) pass_ms();
            start_kiosk();
        } else {
            pass(kiosk_->restart.wait_s(now_s_ - start_s));
        }
    }
    forget_heard();
    figures_.session_s = now_s_;
    figures_.failure = findings_.first();
    figures_.failed_seeds = figures_.failure ? 1 : 0;
    if (kiosk_) figures_.pictures += kiosk_->servo->pictures;
    figures_.sheets = printer_.sheets();
    return figures_;
}

void SimHouse::start_kiosk() {
    kiosk_ = std::make_unique<KioskLife>(
        KioskPlace{now_s_, folder_ / "site", heard_, [this] { return fate_of_job(); },
                   [this] {
                       const auto minute = static_cast<int>(now_s_ / 60.0);
                       return (12 * 60 + minute + minutes_stepped_) % (24 * 60);
                   },
                   plan_.offers.printer ? &printer_ : nullptr, plan_.offers.braille});
    pages_.begin_anew(now_s_);
    line_.begin_anew();
    session_rules_.begin_anew();
    answers_.excuse(now_s_);
    frames_off_until_s_ = 0.0;
    heard_->problem.clear();
    heard_->headphones = true;
}

/// Does as the guard: runs one servo from its start to its end, then sets zero torque.
void SimHouse::serve_one() {
    auto sockets = socket_pair();
    auto region = SharedRegion::create();
    auto shared = SharedRegion::open(region->descriptor());
    connection_ = std::make_shared<const Connection>(
        Connection{std::move(*region), std::move(sockets->first)});
    servo_ = std::make_unique<ServoLife>(ServoPlace{board_, time_, *this, *hand_, sabotage_},
                                         std::move(*shared), std::move(sockets->second));
    watch_.emplace();
    is_kill_wanted_ = is_servo_frozen_ = is_end_wanted_ = false;
    seen_ticks_ = 0;
    has_ticked_ = is_led_ = false;
    kiosk_->servo->is_homing_wanted = false;
    kiosk_->line.connect(connection_);
    int status = 1;
    try {
        status = servo_->run(stored_);
    } catch (const ServoKilled&) {
        servo_->die();
    }
    hear_servo();
    kiosk_->line.disconnect();
    const bool has_run = connection_->region.channel().servo_beats.load() != 0;
    watch_.reset();
    servo_.reset();
    connection_.reset();
    follow_end(status == 0, has_run);
}

void SimHouse::follow_end(bool is_good, bool has_run) {
    if (is_good || !has_run) return;
    for (int i = 0; i < most_zero_tries && !is_over(); ++i) {
        auto link = std::make_unique<EmulatedLink>(board_, time_);
        link->keep_no_commands();
        const bool is_zero = zero_torque(std::move(link));
        come_to(time_.now_s);
        if (is_zero) return;
        pass(between_tries_s);
    }
}

/// Does everything up to this moment of board time.
void SimHouse::come_to(double board_s) {
    time_.now_s = std::max(time_.now_s, board_s);
    board_.advance_to(time_.now_s);
    now_s_ = time_.now_s + skipped_s_;
    if (now_s_ >= next_due_s_) act_all();
}

void SimHouse::act_all() {
    double next_s = 1e18;
    for (Actor& actor : actors_) {
        if (actor.due_s <= now_s_) {
            (this->*actor.act)();
            actor.due_s = std::max(actor.due_s + actor.every_s, now_s_);
        }
        next_s = std::min(next_s, actor.due_s);
    }
    next_due_s_ = next_s;
}

void SimHouse::pass_ms() {
    come_to(time_.now_s + tick_s);
    look_at_tick();
}

void SimHouse::pass(double span_s) {
    const double end_s = time_.now_s + span_s;
    while (time_.now_s < end_s && !is_over()) pass_ms();
}

void SimHouse::sleep_until(std::int64_t t_ns) {
    look_at_tick();
    if (may_skip()) skip();
    come_to(1e-9 * static_cast<double>(t_ns) + dice_.between(0.0, most_jitter_s));
    if (late_s_ > 0.0) {
        const double until_s = time_.now_s + std::exchange(late_s_, 0.0);
        if (is_machine_still_) next_due_s_ = until_s + skipped_s_;
        while (time_.now_s < until_s) pass_ms();
        is_machine_still_ = false;
    }
    while (is_servo_frozen_ && !is_kill_wanted_ && !is_over()) pass_ms();
    if (is_over() && !is_end_wanted_) {
        is_end_wanted_ = true;
        connection_->region.channel().is_stop_wanted = 1;
        if (findings_.first()) is_kill_wanted_ = true;
    }
    if (is_kill_wanted_) throw ServoKilled{};
}

double SimHouse::next_plan_s() const {
    double next_s = plan_.options.span_s;
    if (next_visit_ < plan_.visits.size())
        next_s = std::min(next_s, plan_.visits[next_visit_].at_s);
    if (next_cause_ < plan_.causes.size())
        next_s = std::min(next_s, plan_.causes[next_cause_].at_s);
    return next_s;
}

bool SimHouse::may_skip() const {
    const bool is_quiet = !visitor_ && ongoing_.empty() && !staff_due_s_ && held_ == JointTorques{};
    return is_quiet && now_s_ - last_heard_s_ > quiet_s && is_kiosk_up() && is_servo_ready() &&
           kiosk_->jobs->waiting() == 0 && !is_visit_on(kiosk_->kiosk->visit()) &&
           !kiosk_->servo->is_homing_wanted && next_plan_s() - now_s_ > before_plan_s + 1.0;
}

/// Passes time for the kiosk alone, in long frames.
void SimHouse::skip() {
    const double until_s = next_plan_s() - before_plan_s;
    while (now_s_ < until_s && !is_visit_on(kiosk_->kiosk->visit()) && !findings_.first()) {
        skipped_s_ += skipped_frame_s;
        now_s_ = time_.now_s + skipped_s_;
        frame();
    }
    for (Actor& actor : actors_) actor.due_s = now_s_;
    next_due_s_ = now_s_;
}

/// Beats for the kiosk, checks that the servo lives and hears it, every 2 ms.
void SimHouse::guard() {
    if (!is_kiosk_up() || !connection_ || !watch_) return;
    ServoChannel& channel = connection_->region.channel();
    if (kiosk_->line.is_kiosk_alive(std::llround(1e9 * now_s_))) ++channel.kiosk_beats;
    is_end_wanted_ = is_end_wanted_ || std::exchange(kiosk_->servo->is_homing_wanted, false);
    if (is_end_wanted_) channel.is_stop_wanted = 1;
    const bool is_dead = watch_->step(channel, is_end_wanted_, beat_s);
    if (is_dead && sabotage_ != Sabotage::deaf_guard) is_kill_wanted_ = true;
    hear_servo();
}

void SimHouse::hear_servo() {
    Arrival arrival;
    while (receive(connection_->socket, arrival) == ReceiveStatus::received) {
        const Message& message = arrival.message;
        if (message.kind == MessageKind::say || message.kind == MessageKind::failed)
            kiosk_->line.say(line_of(message));
        if (message.kind == MessageKind::home)
            stored_ = calibration_of(message, stored_).value_or(stored_);
        if (message.kind == MessageKind::failed || message.kind == MessageKind::notice)
            kiosk_->line.note(line_of(message));
    }
}

void SimHouse::servo_main() {
    if (servo_ && !is_servo_frozen_) servo_->serve();
}

void SimHouse::frame() {
    if (!is_kiosk_up() || now_s_ < frames_off_until_s_) return;
    heard_->now_s = now_s_;
    if (kiosk_->braille) kiosk_->braille->now_s = now_s_;
    printer_.step();
    welcome();
    accompany();
    staff();
    kiosk_->kiosk->step(std::llround(1e9 * now_s_));
    (void)kiosk_->kiosk->take_report();
    if (servo_ && !is_servo_frozen_) servo_->serve();  // the message wakes it
    look_at_frame();
}

/// Gives cues for what the hand met, as the sound's own thread hears it.
void SimHouse::sound() {
    if (!is_kiosk_up() || !servo_) return;
    while (const auto event = kiosk_->servo->next_event()) {
        const CueStep step = cue_step(cues_, *event);
        cues_ = step.state;
        if (!step.cue) continue;
        ++figures_.cues;
        hash_.mix(static_cast<std::uint64_t>(step.cue->cue));
        const double after_s = time_.now_s - servo_->loop_start_s() - event->time_s;
        const bool was_frozen = now_s_ - kiosk_frozen_until_s_ < 0.01;
        if (was_frozen) continue;
        figures_.longest_cue_s = std::max(figures_.longest_cue_s, after_s);
        findings_.demand(after_s <= 0.150, "cues", now_s_, [&] {
            return "a cue of the hand came " + std::to_string(after_s) + " s late";
        });
    }
}

}  // namespace touchline
