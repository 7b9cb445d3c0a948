#include "app/force/servo/servo_process.h"

#include "app/force/servo/running_servo.h"
#include "app/force/servo/servo_connection.h"
#include "app/isolation/process/thread_signals.h"
#include "config/types/pinned.h"
#include "config/types/steady_clock.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <mutex>
#include <thread>
#include <utility>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace touchline {
namespace {

constexpr int most_zero_tries = 100;
constexpr int between_tries_ms = 10;
constexpr int longest_wait_ms = 500;  // with no turn of the guard

double seconds_since(std::int64_t start_ns) {
    return 1e-9 * static_cast<double>(steady_now_ns() - start_ns);
}

/// A killed process needs some milliseconds to give its memory back; its threads are gone at once.
bool is_loop_dead(const ServoChannel& channel) {
    const std::int32_t process = channel.loop_process, thread = channel.loop_thread;
    return process > 0 && thread > 0 && syscall(SYS_tgkill, process, thread, 0) != 0 &&
           errno == ESRCH;
}

}  // namespace

class ServoProcess::Guard : private Pinned {
  public:
    explicit Guard(ServoProcessOptions options)
        : options_(std::move(options)),
          wake_(::eventfd(0, EFD_CLOEXEC)),
          thread_([this] { run(); }) {}

    ~Guard() {
        is_ending_ = true;
        wake();
        thread_.join();
    }

    ServoConnection line;

    /// Ends the servo: the one started next homes its device.
    void home_again() { want_homing(std::nullopt); }

    /// Takes effect with the next servo.
    void choose_kind(const std::string& profile) { want_homing(profile); }

    /// How often the guard has looked, with or without a servo.
    [[nodiscard]] std::uint64_t turns() const { return turns_; }

  private:
    void want_homing(const std::optional<std::string>& kind) {
        {
            const std::lock_guard lock(wish_mutex_);
            if (kind) chosen_kind_ = kind;
            is_homing_wanted_ = true;
            line.say(std::string(is_starting));
        }
        wake();
    }

    void wake() {
        const std::uint64_t one = 1;
        (void)!::write(wake_.number(), &one, sizeof one);
    }

    void run() {
        leave_signals_to_main_thread();
        become_guard();
        while (!is_ending_) {
            const std::int64_t start_ns = steady_now_ns();
            serve_one();
            const double wait_s = restart_.wait_s(seconds_since(start_ns));
            if (!handover_) rest_ms(static_cast<int>(1e3 * wait_s));
        }
    }

    /// Runs one servo from its start to its end, and writes zero torque after it.
    void serve_one() {
        take_wishes();
        const auto taken = std::exchange(handover_, std::nullopt);
        if (options_.kind && options_.kind->empty()) return wait_for_kind();
        const std::int64_t start_ns = steady_now_ns();
        const auto arguments = taken ? options_.hand_over(*taken) : options_.arguments;
        auto region = SharedRegion::create();
        auto met = options_.summons.empty() ? start_servo(options_.program, arguments)
                                            : summon_servo(options_.summons, arguments);
        if (!met || !region) {
            const std::string why = met ? region.error().line : met.error().line;
            say(why);
            line.note(why);
            return;
        }
        RunningServo& servo = met->peer;
        const auto connection = std::make_shared<const Connection>(
            Connection{std::move(*region), std::move(met->socket)});
        (void)send(connection->socket, message_of(MessageKind::region),
                   &connection->region.descriptor());
        line.connect(connection);
        watch(servo, *connection);
        hear_the_rest(*connection);
        line.disconnect();
        const std::int64_t dead_ns = steady_now_ns();
        const std::string end = servo.end(is_done_);
        const ServoChannel& channel = connection->region.channel();
        const bool has_run = channel.servo_beats.load() != 0;
        const bool is_again = taken && seconds_since(start_ns) < Restart::healthy_s;
        auto handover = is_again ? std::nullopt : handover_from(channel, dead_ns);
        if (!end.empty() && has_run && zero(end, dead_ns) == ZeroedBoard::kept)
            handover_ = std::move(handover);
        held_.reset();
    }

    /// What the next servo needs to go on; nothing if anything is in doubt.
    [[nodiscard]] std::optional<Handover> handover_from(const ServoChannel& channel,
                                                        std::int64_t dead_ns) const {
        const bool is_sure = options_.hand_over && place_ && held_ && !has_failed_ &&
                             !is_homing_wanted_ && channel.is_device_silent == 0 &&
                             channel.fault == static_cast<std::uint8_t>(Fault::none);
        if (!is_sure) return std::nullopt;
        Handover handover{*place_,
                          {channel.joint_1, channel.joint_2},
                          dead_ns,
                          channel.motor_heat,
                          held_->bus_path};
        return is_sound(handover) ? std::optional(std::move(handover)) : std::nullopt;
    }

    /// The next servo takes up the wishes so far. Later wishes end it again.
    void take_wishes() {
        std::optional<std::string> kind;
        {
            const std::lock_guard lock(wish_mutex_);
            if (is_homing_wanted_.exchange(false)) handover_.reset();
            kind = std::exchange(chosen_kind_, std::nullopt);
        }
        if (!kind || !options_.keep_kind) return;
        options_.arguments = options_.keep_kind(*kind);
        options_.kind = kind;
    }

    /// The torque that the board's last program left is unknown; zero is the same for all kinds. A
    /// board that confirmed zero is left alone.
    void wait_for_kind() {
        if (!is_idle_) is_idle_ = options_.zero_torque({}).has_value();
        say(std::string(kind_wanted));
    }

    /// Says nothing if a newer servo is wanted, because this one's words are out of date.
    void say(const std::string& words) {
        const std::lock_guard lock(wish_mutex_);
        if (!is_homing_wanted_) line.say(words);
    }

    /// Beats and looks until the child is dead.
    void watch(const RunningServo& servo, const Connection& connection) {
        ServoChannel& channel = connection.region.channel();
        ServoWatch watch;
        std::int64_t last_ns = steady_now_ns();
        is_closed_ = false;
        is_done_ = false;
        is_cut_ = false;
        has_failed_ = false;
        place_.reset();
        held_.reset();
        while (!is_dead(servo, connection)) {
            const std::int64_t now_ns = steady_now_ns();
            const double dt_s = 1e-9 * static_cast<double>(now_ns - std::exchange(last_ns, now_ns));
            if (line.is_kiosk_alive(now_ns)) channel.kiosk_beats.fetch_add(1);
            const bool is_end_wanted = is_ending_ || is_homing_wanted_;
            if (is_end_wanted) channel.is_stop_wanted = 1;
            if (watch.step(channel, is_end_wanted, dt_s)) kill(servo);
            if (is_loop_dead(channel)) cut_first();
        }
    }

    /// Dying takes a moment; the torque is cut at once.
    void kill(const RunningServo& servo) {
        servo.kill();
        cut_first();
    }

    /// The process is not dead yet, so the torque is cut once more when it is.
    void cut_first() {
        if (!std::exchange(is_cut_, true)) (void)cut();
    }

    [[nodiscard]] bool cut() const {
        return held_ && options_.cut_torque && options_.cut_torque(*held_);
    }

    /// Waits for a beat's time, and reads the servo's messages meanwhile.
    bool is_dead(const RunningServo& servo, const Connection& connection) {
        ++turns_;
        std::array<pollfd, 2> waiting{
            {{servo.pidfd().number(), POLLIN, 0}, {connection.socket.number(), POLLIN, 0}}};
        (void)::poll(waiting.data(), is_closed_ ? 1 : 2, guard_beat_ms);
        if (waiting[0].revents != 0) return true;
        Arrival arrival;
        const ReceiveStatus status = receive(connection.socket, arrival);
        if (status == ReceiveStatus::received) hear(arrival);
        is_closed_ = status == ReceiveStatus::gone;
        return false;
    }

    /// The servo's last message may say why it died.
    void hear_the_rest(const Connection& connection) {
        Arrival arrival;
        while (!is_closed_ && receive(connection.socket, arrival) == ReceiveStatus::received)
            hear(arrival);
    }

    void hear(Arrival& arrival) {
        const Message& message = arrival.message;
        if (auto held = held_board_of(arrival)) held_ = std::move(held);
        // The reason for a missing servo stays until a servo has its device, which then sends empty
        // words.
        if (message.kind == MessageKind::say || message.kind == MessageKind::failed)
            say(line_of(message));
        if (message.kind == MessageKind::done) is_done_ = true;
        if (message.kind == MessageKind::failed) has_failed_ = true;
        if (message.kind == MessageKind::place) place_ = place_of(message);
        if (message.kind == MessageKind::home && options_.keep_home)
            options_.arguments = options_.keep_home(message);
        if (message.kind == MessageKind::failed || message.kind == MessageKind::notice) {
            line.note(line_of(message));
        }
    }

    ZeroedBoard zero(const std::string& how, std::int64_t dead_ns) {
        const bool is_cut = cut();
        double after_s = seconds_since(dead_ns);
        const std::string bus_path = held_ ? held_->bus_path : std::string();
        held_.reset();  // so that the board can be opened
        for (int i = 0; i < most_zero_tries; ++i) {
            const auto zeroed = options_.zero_torque(bus_path);
            if (zeroed) {
                if (!is_cut) after_s = seconds_since(dead_ns);
                line.note("the servo ended with " + how + "; the torque was zeroed " +
                          std::to_string(std::lround(1e3 * after_s)) + " ms later");
                return *zeroed;
            }
            ++turns_;
            ::poll(nullptr, 0, between_tries_ms);
        }
        line.note("the servo ended with " + how +
                  " and the device cannot be reached: switch the power of its motors off");
        return ZeroedBoard::not_confirmed;
    }

    /// Waits, or ends early when somebody wants something.
    void rest_ms(int span_ms) {
        for (; span_ms > 0 && !is_ending_ && !is_homing_wanted_; span_ms -= longest_wait_ms) {
            ++turns_;
            pollfd waiting{wake_.number(), POLLIN, 0};
            std::uint64_t wakes = 0;
            if (::poll(&waiting, 1, std::min(span_ms, longest_wait_ms)) > 0)
                (void)!::read(wake_.number(), &wakes, sizeof wakes);
        }
    }

    ServoProcessOptions options_;
    Descriptor wake_;
    std::atomic<bool> is_ending_{false};
    std::mutex wish_mutex_;  // for the next two, and the words about them
    std::atomic<bool> is_homing_wanted_{false};
    std::optional<std::string> chosen_kind_;  // not yet taken up
    std::atomic<std::uint64_t> turns_{0};
    Restart restart_;
    bool is_idle_ = false;           // the guard's: a board of unknown kind confirmed zero torque
    bool is_closed_ = false;         // likewise: the servo's socket is gone
    bool is_done_ = false;           // likewise: it said that it ended as asked
    bool is_cut_ = false;            // likewise: the torque was cut before it was dead
    bool has_failed_ = false;        // likewise: it said why it ends
    std::optional<HeldBoard> held_;  // likewise: from the servo's message to its end
    std::optional<HandlePlace> place_;  // likewise
    std::optional<Handover> handover_;  // likewise: for the next servo
    std::thread thread_;                // last: it uses all of the above
};

ServoProcess::ServoProcess(ServoProcessOptions options)
    : kind_(options.kind), guard_(std::make_unique<Guard>(std::move(options))) {}

ServoProcess::~ServoProcess() = default;

void ServoProcess::set(const ServoCommands& commands) {
    if (guard_) guard_->line.set(commands);
}

void ServoProcess::feel(const FeltPicture& picture) {
    if (guard_) guard_->line.feel(picture);
}

const HandState& ServoProcess::latest() {
    if (guard_) guard_->line.update(report_, steady_now_ns());
    return report_.hand;
}

ForceStatus ServoProcess::force_status() {
    return report_.force;
}

std::optional<ContactEvent> ServoProcess::next_event() {
    return guard_ ? guard_->line.next_event() : std::nullopt;
}

std::optional<RealTimeTier> ServoProcess::tier() const {
    return guard_ ? guard_->line.tier() : std::nullopt;
}

LatenessBars ServoProcess::lateness() const {
    return guard_ ? guard_->line.lateness() : LatenessBars{};
}

std::uint64_t ServoProcess::beats() {
    return guard_ ? guard_->turns() : 0;
}

std::string ServoProcess::take_notice() {
    return guard_ ? guard_->line.take_notice() : std::string();
}

std::string ServoProcess::device_words() {
    return guard_ ? guard_->line.device_words() : std::string();
}

void ServoProcess::home_again() {
    if (guard_) guard_->home_again();
}

void ServoProcess::choose_kind(const std::string& profile) {
    if (!guard_ || !kind_) return;
    kind_ = profile;
    guard_->choose_kind(profile);
}

void ServoProcess::hold_recording() {
    if (guard_) guard_->line.ask_recorder(MessageKind::hold);
}

void ServoProcess::keep_recording() {
    if (guard_) guard_->line.ask_recorder(MessageKind::keep);
}

void ServoProcess::forget_recording() {
    if (guard_) guard_->line.ask_recorder(MessageKind::forget);
}

void ServoProcess::stop() {
    guard_.reset();
}

}  // namespace touchline
