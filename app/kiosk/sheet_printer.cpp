#include "app/kiosk/sheet_printer.h"

#include "app/isolation/process/thread_signals.h"
#include "app/kiosk/own_thread.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace touchline {

Printing printing_by(const PrintPrograms& programs) {
    return {
        [programs](const TactileMap& map, const PrintOrder& order, const std::stop_token& stop) {
            return print_map(map, order, programs, stop);
        },
        [programs](const std::string& queue, const std::stop_token& stop) {
            return check_printer(queue, programs, stop);
        }};
}

namespace {

/// False where a look at the queue could not tell, or could not remove what is left.
bool is_clear(PrintEnd end) {
    return end != PrintEnd::not_cleared && end != PrintEnd::no_service &&
           end != PrintEnd::no_answer && end != PrintEnd::not_started;
}

/// What went wrong on the other thread comes out here.
PrintEnd end_of(std::future<PrintEnd>& work) {
    try {
        return work.get();
    } catch (const std::exception&) {
        return PrintEnd::not_started;
    }
}

}  // namespace

std::future<PrintEnd> print_beside(std::function<PrintEnd()> work) {
    return on_own_thread(
        [work = std::move(work)] {
            leave_signals_to_main_thread();
            return work();
        },
        PrintEnd::not_started);
}

/// A future of std::async waits for its thread.
SheetPrinter::~SheetPrinter() {
    stop_.request_stop();
}

void SheetPrinter::print(TactileMap map, PrintOrder order) {
    waiting_ = Sheet{std::move(map), std::move(order)};
}

std::optional<PrintEnd> SheetPrinter::step(const std::string& queue, double now_s,
                                           bool is_watched) {
    if (queue != queue_) {
        queue_ = queue;
        looked_s_.reset();
        condition_.reset();
    }
    std::optional<PrintEnd> sheet_end;
    if (under_way_.valid()) {
        if (under_way_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
            return std::nullopt;
        const PrintEnd end = end_of(under_way_);
        is_sheet_ ? note_sheet() : note_look(end);
        if (is_sheet_) sheet_end = end;
    }
    begin_next(now_s, is_watched);
    return sheet_end;
}

void SheetPrinter::note_sheet() {
    if (std::ranges::find(unclear_, at_) == unclear_.end()) unclear_.push_back(at_);
    looked_s_.reset();
    looked_back_s_.reset();
}

void SheetPrinter::note_look(PrintEnd end) {
    if (is_clear(end)) std::erase(unclear_, at_);
    if (at_ == queue_ && looked_s_) condition_ = end;  // else the queue was another one meanwhile
}

/// The settings name another queue now, or none.
std::optional<std::string> SheetPrinter::left_behind() const {
    const auto found =
        std::ranges::find_if(unclear_, [this](const std::string& each) { return each != queue_; });
    return found == unclear_.end() ? std::nullopt : std::optional(*found);
}

void SheetPrinter::look_at(const std::string& queue) {
    at_ = queue;
    under_way_ = start_(
        [check = printing_.check, stop = stop_.get_token(), queue] { return check(queue, stop); });
}

void SheetPrinter::begin_next(double now_s, bool is_watched) {
    const auto is_due = [now_s](const std::optional<double>& last_s, double every_s) {
        return !last_s || now_s - *last_s >= every_s;
    };
    is_sheet_ = waiting_.has_value();
    if (is_sheet_) {
        at_ = waiting_->order.queue;
        under_way_ = start_(
            [print = printing_.print, stop = stop_.get_token(),
             sheet = *std::exchange(waiting_, {})] { return print(sheet.map, sheet.order, stop); });
    } else if (!queue_.empty() &&
               is_due(looked_s_, is_watched ? watched_check_every_s : check_every_s)) {
        looked_s_ = now_s;
        look_at(queue_);
    } else if (const auto old = left_behind(); old && is_due(looked_back_s_, check_every_s)) {
        looked_back_s_ = now_s;
        look_at(*old);
    }
}

}  // namespace touchline
