// The braille line that brltty drives, of whatever make.
//
//   texts, the item with the focus ──> LineContents ──> cells ──> BrlAPI ──> brltty ──> display
//   display's keys ──> brltty ──> BrlAPI ──> pages are turned here; roles go to the kiosk
//
// Threads: the kiosk's, and one of its own, which translates and talks to brltty. They share a list
// of orders and one of events under a mutex, held for as long as a value is moved. Where no brltty
// is the thread looks for one every line_look_s; otherwise it sleeps until something comes. On a
// machine that has no thread left there is no line, and the report says so.
#pragma once

#include "app/braille/visitor_braille.h"

#include <atomic>
#include <deque>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <variant>
#include <vector>

namespace touchline {

/// A line that was plugged in, or a brltty that starts again, is there that soon.
inline constexpr double line_look_s = 5.0;

class BrailleLine final : public VisitorBraille {
  public:
    explicit BrailleLine(BrailleUse use);
    ~BrailleLine() override;

    void say(const LineText& text, LineUse use) override;
    void rest(const LineText& text) override;
    void choose(BrailleUse use) override;
    [[nodiscard]] std::optional<LineEvent> next_event() override;

    [[nodiscard]] bool is_there() const override { return is_there_; }

    [[nodiscard]] std::string take_report() override;
    void forget() override;

  private:
    struct Said {
        LineText text;
        LineUse use = LineUse::now;
    };

    struct Resting {
        LineText text;
    };

    struct Forget {};

    using Order = std::variant<Said, Resting, BrailleUse, Forget>;

    struct Desk;  // what the thread has before it

    void give(Order order);
    void run(const std::stop_token& stop);
    void take_orders(Desk& desk, double now_s);
    void look_for_display(Desk& desk, double now_s);
    void take_keys(Desk& desk, double now_s);
    void wait(const Desk& desk, double now_s) const;
    void tell(const LineEvent& event);
    void report(const std::string& line);

    int wake_ = -1;                     // an eventfd
    LineText resting_;                  // the kiosk's thread: what it told last
    BrailleUse use_ = BrailleUse::off;  // the same
    std::atomic<bool> is_there_ = false;
    mutable std::mutex mutex_;
    std::vector<Order> orders_;
    std::deque<LineEvent> events_;
    std::string report_;
    std::jthread thread_;  // the last: it ends before what it uses
};

}  // namespace touchline
