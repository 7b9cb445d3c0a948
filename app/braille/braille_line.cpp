#include "app/braille/braille_line.h"

#include "app/braille/brlapi_display.h"
#include "app/braille/line_keys.h"
#include "app/isolation/process/thread_signals.h"
#include "config/types/steady_clock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace touchline {
namespace {

/// More than a kiosk says or a reader presses while the thread is busy once.
constexpr std::size_t most_waiting = 256;

double now_of_clock_s() {
    return 1e-9 * static_cast<double>(steady_now_ns());
}

}  // namespace

struct BrailleLine::Desk {
    LineContents contents;
    std::unique_ptr<BrlapiDisplay> display;  // null: no brltty
    BrailleUse use = BrailleUse::off;
    double look_s = 0.0;   // when to look for a brltty again
    BrailleCells on_line;  // as written last
    std::string problem;   // of the tables, as reported last
    std::string refusal;   // of brltty, as reported last

    [[nodiscard]] std::size_t width() const {
        return display && !display->is_lost() ? display->width() : 0;
    }
};

BrailleLine::BrailleLine(BrailleUse use)
    : wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), use_(use), orders_{use} {
    try {
        thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
    } catch (const std::system_error&) {
        report("the braille line has no thread to run on; start the kiosk again");
    }
}

BrailleLine::~BrailleLine() {
    thread_.request_stop();
    give(Forget{});
    if (thread_.joinable()) thread_.join();
    close(wake_);
}

void BrailleLine::give(Order order) {
    if (!thread_.joinable()) return;  // nobody would ever take it
    {
        const std::lock_guard lock(mutex_);
        if (orders_.size() >= most_waiting) {
            const auto oldest = std::ranges::find_if(
                orders_, [](const Order& each) { return std::holds_alternative<Said>(each); });
            if (oldest != orders_.end()) orders_.erase(oldest);
        }
        orders_.push_back(std::move(order));
    }
    const std::uint64_t one = 1;
    (void)!write(wake_, &one, sizeof one);
}

void BrailleLine::say(const LineText& text, LineUse use) {
    give(Said{text, use});
}

void BrailleLine::rest(const LineText& text) {
    if (text == resting_) return;
    resting_ = text;
    give(Resting{text});
}

void BrailleLine::choose(BrailleUse use) {
    if (use == use_) return;
    use_ = use;
    give(use);
}

void BrailleLine::forget() {
    resting_ = {};
    give(Forget{});
}

std::optional<LineEvent> BrailleLine::next_event() {
    const std::lock_guard lock(mutex_);
    if (events_.empty()) return std::nullopt;
    const LineEvent event = events_.front();
    events_.pop_front();
    return event;
}

std::string BrailleLine::take_report() {
    const std::lock_guard lock(mutex_);
    return std::exchange(report_, {});
}

void BrailleLine::tell(const LineEvent& event) {
    const std::lock_guard lock(mutex_);
    if (events_.size() < most_waiting) events_.push_back(event);
}

void BrailleLine::report(const std::string& line) {
    const std::lock_guard lock(mutex_);
    report_ = line;  // the newest is what holds
}

void BrailleLine::run(const std::stop_token& stop) {
    leave_signals_to_main_thread();  // that of a socket whose other end is gone is for nobody
    Desk desk;
    while (!stop.stop_requested()) {
        const double now_s = now_of_clock_s();
        take_orders(desk, now_s);
        look_for_display(desk, now_s);
        take_keys(desk, now_s);
        const std::size_t width = desk.width();
        if (width != desk.contents.width()) {
            desk.contents.set_width(width, now_s);
            desk.on_line.clear();
            is_there_ = width > 0;
            report(width > 0 ? fmt::format("the braille line has {} cells", width)
                             : std::string("the braille line is gone"));
        }
        desk.contents.pass(now_s);
        if (width > 0 && desk.contents.shown() != desk.on_line) {
            desk.on_line = desk.contents.shown();
            desk.display->show(desk.on_line);
        }
        if (desk.contents.problem() != desk.problem) {
            desk.problem = desk.contents.problem();
            if (!desk.problem.empty()) report(desk.problem);
        }
        wait(desk, now_s);
    }
    desk.contents.forget();
    if (desk.width() > 0) desk.display->show(BrailleCells(desk.width(), 0));
}

void BrailleLine::take_orders(Desk& desk, double now_s) {
    std::vector<Order> orders;
    {
        const std::lock_guard lock(mutex_);
        orders.swap(orders_);
    }
    for (Order& order : orders) {
        if (auto* const said = std::get_if<Said>(&order)) {
            desk.contents.say(std::move(said->text), said->use, now_s);
        } else if (auto* const resting = std::get_if<Resting>(&order)) {
            desk.contents.rest(std::move(resting->text), now_s);
        } else if (const auto* const use = std::get_if<BrailleUse>(&order)) {
            desk.use = *use;
            desk.look_s = now_s;
            desk.contents.choose(*use == BrailleUse::contracted ? BrailleGrade::contracted
                                                                : BrailleGrade::uncontracted,
                                 now_s);
        } else {
            desk.contents.forget();
        }
    }
}

void BrailleLine::look_for_display(Desk& desk, double now_s) {
    if (desk.use == BrailleUse::off || (desk.display && desk.display->is_lost())) {
        desk.display.reset();
        desk.look_s = now_s + line_look_s;
    }
    if (desk.use == BrailleUse::off || desk.display || now_s < desk.look_s) return;
    desk.look_s = now_s + line_look_s;
    const std::string before = std::exchange(desk.refusal, {});
    desk.display = BrlapiDisplay::open(desk.refusal);
    if (!desk.refusal.empty() && desk.refusal != before) report(desk.refusal);
}

void BrailleLine::take_keys(Desk& desk, double now_s) {
    if (!desk.display) return;
    while (const auto code = desk.display->next_key()) {
        const auto key = line_key_of(*code);
        if (!key) {
            tell(DeadLineKey{});
        } else if (const auto* const role = std::get_if<KeyRole>(&*key)) {
            tell(*role);
        } else {
            tell(LineTurned{!desk.contents.turn(std::get<LineTurn>(*key), now_s)});
        }
    }
}

void BrailleLine::wait(const Desk& desk, double now_s) const {
    std::optional<double> until_s = desk.contents.due_s();
    const bool is_lost = desk.display && desk.display->is_lost();
    if (desk.use != BrailleUse::off && (!desk.display || is_lost)) until_s = desk.look_s;
    if (is_lost) until_s = now_s;
    int most_ms = -1;
    if (until_s) most_ms = static_cast<int>(std::ceil(1e3 * std::max(*until_s - now_s, 0.0)));
    std::array<pollfd, 2> watched{pollfd{wake_, POLLIN, 0}, pollfd{-1, POLLIN, 0}};
    if (desk.display && !is_lost) watched[1].fd = desk.display->descriptor();
    (void)poll(watched.data(), watched.size(), most_ms);
    std::uint64_t woken = 0;
    (void)!read(wake_, &woken, sizeof woken);
}

}  // namespace touchline
