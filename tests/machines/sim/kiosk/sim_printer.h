// The site's printer and its CUPS on a virtual clock: sheets take their time, fail, or stay in the
// spool of a CUPS that went away. Outlives the kiosk, as both do. Threads: one.
#pragma once

#include "app/kiosk/sheet_printer.h"
#include "tests/machines/sim/kiosk/plan.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

class SimPrinter {
  public:
    /// `now_s` (site time) must outlive it.
    SimPrinter(const double& now_s, std::uint64_t seed) : now_s_(now_s), dice_(seed) {}

    /// For a SheetPrinter, with start(): what its two functions do, and when they are done.
    [[nodiscard]] Printing printing() {
        return {[this](const TactileMap&, const PrintOrder&, const std::stop_token&) {
                    return print();
                },
                [this](const std::string&, const std::stop_token&) { return check(); }};
    }

    [[nodiscard]] PrintStart start() {
        return [this](const std::function<PrintEnd()>& work) {
            const PrintEnd end = work();
            std::promise<PrintEnd> told;
            std::future<PrintEnd> later = told.get_future();
            under_way_.push_back(
                {now_s_ + takes_s_, end, std::exchange(page_, {}), std::move(told)});
            return later;
        };
    }

    /// Time has passed. What is under way comes to its end, also of a kiosk that is gone.
    void step() {
        std::erase_if(under_way_, [this](UnderWay& each) {
            if (each.due_s > now_s_) return false;
            if (each.page) std::erase(spool_, *each.page);
            each.told.set_value(each.end);
            return true;
        });
    }

    /// Since when the oldest page has been in the spool of a CUPS that answers; nothing: it is
    /// empty, or CUPS is away.
    [[nodiscard]] std::optional<double> page_since_s() const {
        if (spool_.empty() || !answers()) return std::nullopt;
        return std::max(spool_.front().since_s, away_until_s_);
    }

    /// CUPS removes nothing any more.
    void keep_all() { keeps_all_ = true; }

    [[nodiscard]] std::uint64_t sheets() const { return sheets_; }

  private:
    struct Page {
        std::uint64_t number = 0;
        double since_s = 0.0;

        friend bool operator==(const Page&, const Page&) = default;
    };

    struct UnderWay {
        double due_s = 0.0;
        PrintEnd end = PrintEnd::printed;
        std::optional<Page> page;  // goes with the end
        std::promise<PrintEnd> told;
    };

    static constexpr double look_s = 0.05;
    static constexpr double given_up_s = 8.0;  // on a printer in trouble, or a CUPS that is gone

    [[nodiscard]] bool answers() const { return now_s_ >= away_until_s_; }

    [[nodiscard]] PrintEnd print() {
        takes_s_ = look_s;
        if (!answers()) return PrintEnd::no_service;
        const Page page{++sheets_, now_s_};
        spool_.push_back(page);
        takes_s_ = given_up_s;
        const double share = dice_.share();
        if (share > 0.8) {  // CUPS goes away with the page
            away_until_s_ = now_s_ + dice_.between(1.0, 90.0);
            return PrintEnd::no_answer;
        }
        if (!keeps_all_) page_ = page;
        constexpr std::array troubles{PrintEnd::no_paper, PrintEnd::needs_hand, PrintEnd::offline,
                                      PrintEnd::failed};
        if (share > 0.6) return troubles.at(dice_.below(troubles.size()));
        takes_s_ = dice_.between(5.0, 60.0);
        return PrintEnd::printed;
    }

    [[nodiscard]] PrintEnd check() {
        takes_s_ = look_s;
        if (!answers()) return PrintEnd::no_service;
        if (keeps_all_ && !spool_.empty()) return PrintEnd::not_cleared;
        spool_.clear();
        return PrintEnd::printed;
    }

    const double& now_s_;
    Dice dice_;
    std::vector<Page> spool_;  // oldest first
    std::vector<UnderWay> under_way_;
    double away_until_s_ = 0.0;
    double takes_s_ = look_s;   // of what was asked last
    std::optional<Page> page_;  // the same: removed at its end
    bool keeps_all_ = false;
    std::uint64_t sheets_ = 0;
};

}  // namespace touchline
