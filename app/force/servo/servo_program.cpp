#include "app/force/servo/servo_program.h"

#include "app/force/servo/black_box.h"
#include "app/force/servo/messages.h"
#include "config/types/steady_clock.h"

#include <array>
#include <csignal>
#include <ctime>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <malloc.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

// The headers of this C library lack this declaration.
extern "C" {
#include <sys/pidfd.h>
}

namespace touchline {
namespace {

// Handlers have no arguments of their own.
std::atomic<Servo*> servo_to_cut{nullptr};
std::atomic<ServoChannel*> channel_to_end{nullptr};
std::atomic<bool> is_end_asked_for{false};
EmergencyZero emergency_zero;

static_assert(std::atomic<Servo*>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

constexpr std::array end_signals{SIGTERM, SIGINT};
constexpr std::array crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU};

void cut() noexcept {
    if (Servo* const servo = servo_to_cut.load()) servo->cut();
}

void end(int /*signal*/) {
    is_end_asked_for = true;
    if (ServoChannel* const channel = channel_to_end.load()) channel->is_stop_wanted = 1;
}

void lose_kiosk(int /*signal*/) {
    is_end_asked_for = true;
    cut();
}

/// Returns into the signal's default action: raises it again, after its handler is gone.
void crash(int signal) {
    cut();
    constexpr timespec three_ticks{0, 3'000'000};
    nanosleep(&three_ticks, nullptr);
    alarm(1);  // a write that hangs must not keep a dead servo alive; the kiosk's guard takes over
    if (emergency_zero.write != nullptr) emergency_zero.write(emergency_zero.device);
    (void)raise(signal);
}

void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action {};

    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

/// A stack for the main thread's handlers, in case its own stack ran out.
void make_alternate_stack() {
    static std::array<char, std::size_t{64} * 1024> room;
    stack_t stack{};
    stack.ss_sp = room.data();
    stack.ss_size = room.size();
    sigaltstack(&stack, nullptr);
}

constexpr std::int64_t longest_absence_ns = 2'000'000'000;
constexpr int hello_ms = 5000;
constexpr std::size_t most_words = 32;
constexpr int look_ms = 50;                  // how often to check for ends that wake nobody
constexpr rlim_t longest_turn_us = 100'000;  // longest run of the real-time thread without a sleep

/// A crash leaves nothing of a visitor's picture behind. malloc keeps the memory that it has, so
/// that building a scene never gives locked memory back and asks for it again. A file that may not
/// grow is a failed write, as on a full disk, and does not end the process.
void harden() {
    (void)signal(SIGXFSZ, SIG_IGN);
    const rlimit none{0, 0};
    (void)setrlimit(RLIMIT_CORE, &none);
    (void)prctl(PR_SET_DUMPABLE, 0UL, 0UL, 0UL, 0UL);
    (void)prctl(PR_SET_PDEATHSIG, static_cast<unsigned long>(SIGHUP), 0UL, 0UL, 0UL);
    (void)mallopt(M_TRIM_THRESHOLD, -1);
    (void)mallopt(M_MMAP_MAX, 0);
}

/// Soft limit below hard: SIGXCPU at the soft limit zeroes the torque, SIGKILL comes at the hard
/// one.
void limit_real_time() {
    const rlimit turn{longest_turn_us, 10 * longest_turn_us};
    (void)setrlimit(RLIMIT_RTTIME, &turn);
}

/// Waits for a message. Nothing if the kiosk is gone or says nothing for that long.
std::optional<Arrival> wait_for_message(const Descriptor& socket, int longest_ms) {
    pollfd waiting{socket.number(), POLLIN, 0};
    if (::poll(&waiting, 1, longest_ms) <= 0) return std::nullopt;
    Arrival arrival;
    if (receive(socket, arrival) != ReceiveStatus::received) return std::nullopt;
    return arrival;
}

ServoOptions options_for(const OpenedDevice& opened) {
    ServoOptions options;
    options.lock = MemoryLock::whole;
    options.has_motors = opened.has_motors;
    options.watches_kiosk = true;
    options.recorded_ticks = recorded_ticks(options.period_s);
    options.motor_heat = opened.motor_heat;
    return options;
}

class ServoProgram {
  public:
    ServoProgram(Descriptor socket, SharedRegion region, std::vector<std::string> words)
        : socket_(std::move(socket)),
          region_(std::move(region)),
          words_(std::move(words)),
          servo_(region_.channel()) {}

    int run(const DeviceOpener& open_device) {
        auto opened = open_device(opening());
        if (!opened) return fail(opened.error().line);
        tell(MessageKind::say, {});
        if (opened->place) (void)send(socket_, message_of(*opened->place));
        BlackBox box(recordings_folder(), std::string(opened->profile.name),
                     [this](const std::string& line) { tell(MessageKind::notice, line); });
        box_ = &box;
        const auto started =
            servo_.start(std::move(opened->device), opened->profile, options_for(*opened));
        if (!started) return fail(started.error().line);
        limit_real_time();
        const std::string lost = run_loop(*opened, box);
        if (opened->release && !opened->release() && lost.empty())
            return fail("the board did not confirm zero torque: switch its motors off");
        if (!lost.empty()) return fail(lost);
        tell(MessageKind::done, {});
        return 0;
    }

  private:
    /// Runs until the end is asked for, or until the device is lost; then returns why. Gives the
    /// device back.
    std::string run_loop(OpenedDevice& opened, BlackBox& box) {
        const ZeroOnSignal cut(servo_, region_.channel(), opened.zero);
        answered_ns_ = steady_now_ns();
        std::string lost;
        while (lost.empty() && !cut.is_end_asked() && region_.channel().is_stop_wanted == 0 &&
               serve()) {
            box.update(servo_.recording(), fault());
            if (has_lost_place(opened))
                lost = "the handle has lost its place; its home is found anew";
            if (is_device_gone()) lost = "the device does not answer any more: check its plug";
        }
        opened.device = servo_.stop();
        const std::string why = !lost.empty() && opened.trouble ? opened.trouble() : std::string();
        return why.empty() ? lost : why;
    }

    int fail(const std::string& line) {
        (void)send(socket_, message_of(MessageKind::failed, line));
        return 1;
    }

    void tell(MessageKind kind, const std::string& line) {
        (void)send(socket_, message_of(kind, line));
    }

    /// A caller of goes_on is alive, so each call counts as a beat.
    Opening opening() {
        return {[this](const std::string& words) { tell(MessageKind::say, words); },
                [this] {
                    region_.channel().servo_beats.fetch_add(1);
                    return region_.channel().is_stop_wanted == 0;
                },
                [this](const Calibration& found) { (void)send(socket_, message_of(found)); },
                [this](bool is_on) { mark_force(is_on); },
                [this](const UsbNode& node) { share(node); },
                words_};
    }

    /// Marks the force as the loop does, while there is no loop yet.
    void mark_force(bool is_on) {
        ServoChannel& channel = region_.channel();
        if (is_on) channel.begin_loop();
        channel.is_force_on = is_on ? 1 : 0;
        if (!is_on) channel.end_loop();
    }

    void share(const UsbNode& node) {
        const Descriptor copy(fcntl(node.descriptor, F_DUPFD_CLOEXEC, 0));
        (void)send(socket_, message_of(node), &copy);
    }

    static bool has_lost_place(const OpenedDevice& opened) {
        return opened.has_lost_place != nullptr && opened.has_lost_place->load();
    }

    [[nodiscard]] Fault fault() { return static_cast<Fault>(region_.channel().fault.load()); }

    /// Lost and not back for two seconds: the next servo looks for it anew.
    bool is_device_gone() {
        const std::int64_t now_ns = steady_now_ns();
        if (region_.channel().is_device_silent == 0) answered_ns_ = now_ns;
        return now_ns - answered_ns_ > longest_absence_ns;
    }

    /// Waits for one message and carries it out. False if the kiosk is gone.
    bool serve() {
        pollfd waiting{socket_.number(), POLLIN, 0};
        if (::poll(&waiting, 1, look_ms) <= 0) return true;
        Arrival arrival;
        switch (receive(socket_, arrival)) {
            case ReceiveStatus::none:
                return true;
            case ReceiveStatus::gone:
                servo_.cut();
                return false;
            case ReceiveStatus::received:
                break;
        }
        if (arrival.message.kind == MessageKind::scene) feel(arrival);
        if (arrival.message.kind == MessageKind::hold) box_->hold();
        if (arrival.message.kind == MessageKind::keep) box_->keep();
        if (arrival.message.kind == MessageKind::forget) box_->forget();
        return true;
    }

    void feel(const Arrival& arrival) {
        auto scene = scene_of(arrival);
        if (scene) {
            box_->remember(scene->recorded);
            servo_.feel(std::move(scene->scene));
        } else {
            tell(MessageKind::notice, scene.error().line);
        }
    }

    Descriptor socket_;
    SharedRegion region_;
    std::vector<std::string> words_;
    Servo servo_;
    BlackBox* box_ = nullptr;       // set while it runs
    std::int64_t answered_ns_ = 0;  // the device last, or when the loop began
};

}  // namespace

ZeroOnSignal::ZeroOnSignal(Servo& servo, ServoChannel& channel, const EmergencyZero& zero) {
    emergency_zero = zero;
    servo_to_cut = &servo;
    channel_to_end = &channel;
    make_alternate_stack();
    for (const int signal : end_signals) handle(signal, end, 0);
    handle(SIGHUP, lose_kiosk, 0);
    for (const int signal : crash_signals) {
        handle(signal, crash, static_cast<int>(SA_RESETHAND) | SA_ONSTACK);
    }
}

ZeroOnSignal::~ZeroOnSignal() {
    for (const int signal : crash_signals) handle(signal, SIG_DFL, 0);
    servo_to_cut = nullptr;
    channel_to_end = nullptr;
}

bool ZeroOnSignal::is_end_asked() const {
    return is_end_asked_for;
}

int run_servo_program(int socket_number, const DeviceOpener& open_device) {
    harden();
    Descriptor socket(socket_number);
    const Descriptor own(pidfd_open(getpid(), 0));
    (void)send(socket, message_of(MessageKind::here), &own);
    std::vector<std::string> words;
    auto hello = wait_for_message(socket, hello_ms);
    for (; hello && hello->message.kind == MessageKind::word && words.size() < most_words;
         hello = wait_for_message(socket, hello_ms))
        words.push_back(line_of(hello->message));
    if (!hello || hello->message.kind != MessageKind::region) return 1;
    auto region = SharedRegion::open(hello->attached);
    if (!region) {
        (void)send(socket, message_of(MessageKind::failed, region.error().line));
        return 1;
    }
    return ServoProgram(std::move(socket), std::move(*region), std::move(words)).run(open_device);
}

}  // namespace touchline
