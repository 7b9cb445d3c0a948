// The site's printer, as a kiosk uses it: one sheet at a time, and a look at its queue now and
// then. Threads: one; no call waits, but for the end of its object: at most ten seconds, while a
// sheet is laid out.
#pragma once

#include "app/printing/printing.h"
#include "config/types/pinned.h"
#include "config/types/tactile_map.h"

#include <functional>
#include <future>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace touchline {

/// As in app/printing/printing.h. Both wait, and are called on another thread, one at a time.
struct Printing {
    std::function<PrintEnd(const TactileMap& map, const PrintOrder& order,
                           const std::stop_token& stop)>
        print;
    std::function<PrintEnd(const std::string& queue, const std::stop_token& stop)> check;
};

[[nodiscard]] Printing printing_by(const PrintPrograms& programs);

/// Begins work that waits, and returns its end to be.
using PrintStart = std::function<std::future<PrintEnd>(std::function<PrintEnd()> work)>;

/// On a thread of its own; a machine that has none left answers at once.
[[nodiscard]] std::future<PrintEnd> print_beside(std::function<PrintEnd()> work);

/// A printer of sheets; in tests, one that obeys the test's clock.
class SitePrinter : public Interface {
  public:
    /// The end comes in one of the next steps. Not before the end of the sheet before. The sheet
    /// is printed to its end whoever leaves; then nothing of it is left.
    virtual void print(TactileMap map, PrintOrder order) = 0;

    /// `queue`: of the settings; empty: none. `now_s` never falls. Returns the end of a sheet,
    /// once.
    [[nodiscard]] virtual std::optional<PrintEnd> step(const std::string& queue, double now_s,
                                                       bool is_watched) = 0;

    /// What the last look at the queue found; nothing: not yet, or there is no queue.
    [[nodiscard]] virtual std::optional<PrintEnd> condition() const = 0;
};

class SheetPrinter final : public SitePrinter {
  public:
    /// How often the queue is looked at; sooner while somebody looks at what is found, and after a
    /// sheet, of which CUPS may keep something. Once the queue is another one, the one before is
    /// looked at as often, until nothing of ours is there.
    static constexpr double check_every_s = 300.0;
    static constexpr double watched_check_every_s = 10.0;

    explicit SheetPrinter(Printing printing, PrintStart start = print_beside)
        : printing_(std::move(printing)), start_(std::move(start)) {}

    ~SheetPrinter() override;

    void print(TactileMap map, PrintOrder order) override;
    [[nodiscard]] std::optional<PrintEnd> step(const std::string& queue, double now_s,
                                               bool is_watched) override;

    [[nodiscard]] std::optional<PrintEnd> condition() const override { return condition_; }

  private:
    struct Sheet {
        TactileMap map;
        PrintOrder order;
    };

    void note_sheet();
    void note_look(PrintEnd end);
    [[nodiscard]] std::optional<std::string> left_behind() const;
    void look_at(const std::string& queue);
    void begin_next(double now_s, bool is_watched);

    Printing printing_;
    PrintStart start_;
    std::stop_source stop_;
    std::optional<Sheet> waiting_;  // for a look at the queue to end
    std::future<PrintEnd> under_way_;
    bool is_sheet_ = false;                // what is under way
    std::string at_;                       // the queue of what is under way
    std::string queue_;                    // of the settings
    std::optional<double> looked_s_;       // nothing: look as soon as possible
    std::vector<std::string> unclear_;     // queues that printed and were not seen clear since
    std::optional<double> looked_back_s_;  // at one of these that is not queue_
    std::optional<PrintEnd> condition_;
};

}  // namespace touchline
