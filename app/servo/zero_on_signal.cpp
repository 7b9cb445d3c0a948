#include "app/servo/zero_on_signal.h"

#include <array>
#include <atomic>
#include <csignal>
#include <ctime>

#include <signal.h>
#include <unistd.h>

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

}  // namespace touchline
