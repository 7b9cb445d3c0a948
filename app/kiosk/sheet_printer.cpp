#include "app/kiosk/sheet_printer.h"

#include "app/isolation/process/thread_signals.h"

#include <chrono>
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
        const PrintEnd end = under_way_.get();
        if (is_sheet_) {
            sheet_end = end;
            looked_s_.reset();
        } else if (looked_s_) {  // else it was another queue
            condition_ = end;
        }
    }
    begin_next(queue, now_s, is_watched);
    return sheet_end;
}

void SheetPrinter::begin_next(const std::string& queue, double now_s, bool is_watched) {
    const double every_s = is_watched ? watched_check_every_s : check_every_s;
    const bool is_check_due = !queue.empty() && (!looked_s_ || now_s - *looked_s_ >= every_s);
    is_sheet_ = waiting_.has_value();
    if (is_sheet_) {
        under_way_ =
            std::async(std::launch::async, [print = printing_.print, stop = stop_.get_token(),
                                            sheet = *std::exchange(waiting_, {})] {
                leave_signals_to_main_thread();
                return print(sheet.map, sheet.order, stop);
            });
    } else if (is_check_due) {
        looked_s_ = now_s;
        under_way_ = std::async(std::launch::async,
                                [check = printing_.check, stop = stop_.get_token(), queue] {
                                    leave_signals_to_main_thread();
                                    return check(queue, stop);
                                });
    }
}

}  // namespace touchline
