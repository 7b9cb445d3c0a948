// The kiosk's interface to a braille line: the real one (braille_line.h), or one that a test reads.
// Threads: one.
#pragma once

#include "app/braille/line_contents.h"
#include "config/settings/keys.h"
#include "config/types/choices.h"
#include "config/types/pinned.h"

#include <optional>
#include <string>
#include <variant>

namespace touchline {

/// The reader turned a page, or there was none to turn to.
struct LineTurned {
    bool is_at_end = false;
};

/// A key of the display that means nothing here.
struct DeadLineKey {};

using LineEvent = std::variant<KeyRole, LineTurned, DeadLineKey>;

class VisitorBraille : public Interface {
  public:
    /// No call waits for the display.
    virtual void say(const LineText& text, LineUse use) = 0;

    /// What comes after the last text: the item that has the focus. Calls with the same text cost a
    /// comparison.
    virtual void rest(const LineText& text) = 0;

    virtual void choose(BrailleUse use) = 0;

    /// What the reader did, in order.
    [[nodiscard]] virtual std::optional<LineEvent> next_event() = 0;

    [[nodiscard]] virtual bool is_there() const = 0;

    /// One line for the log, without its end; empty: nothing new. Names no text of a visitor.
    [[nodiscard]] virtual std::string take_report() = 0;

    /// The visitor is gone: forgets everything that was said.
    virtual void forget() = 0;
};

/// Stands for the display of a site that has none.
class NoBraille final : public VisitorBraille {
  public:
    void say(const LineText& /*text*/, LineUse /*use*/) override {}

    void rest(const LineText& /*text*/) override {}

    void choose(BrailleUse /*use*/) override {}

    [[nodiscard]] std::optional<LineEvent> next_event() override { return std::nullopt; }

    [[nodiscard]] bool is_there() const override { return false; }

    [[nodiscard]] std::string take_report() override { return {}; }

    void forget() override {}
};

}  // namespace touchline
