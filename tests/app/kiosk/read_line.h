// A braille line of 40 cells without a display: the product's translation and pages, read by a
// test. Threads: one.
#pragma once

#include "app/braille/visitor_braille.h"

#include <deque>
#include <memory>
#include <string>

namespace touchline {

/// What the line's reader has under the fingers; outlives the kiosk's line.
class ReadLine {
  public:
    static constexpr std::size_t width = 40;

    /// As a finger reads it: the page's cells as ASCII braille, without the blanks at its end.
    [[nodiscard]] std::string page() const;

    /// The page is the first of a text.
    [[nodiscard]] bool is_beginning() const { return contents.reading().cell == 0; }

    /// The reader presses a key of the display. The kiosk hears of it in its next frame.
    void turn(LineTurn turn);

    void press(KeyRole role) { events.emplace_back(role); }

    double now_s = 0.0;
    bool is_plugged_in = false;
    LineContents contents;
    std::deque<LineEvent> events;
    BrailleUse use = BrailleUse::off;
    int forgotten = 0;
};

/// The words as ReadLine::page() would have them, without contractions.
[[nodiscard]] std::string as_read(const std::string& words, const std::string& language);

class ReadBraille final : public VisitorBraille {
  public:
    explicit ReadBraille(std::shared_ptr<ReadLine> line) : line_(std::move(line)) {}

    void say(const LineText& text, LineUse use) override {
        line_->contents.say(text, use, line_->now_s);
    }

    void rest(const LineText& text) override { line_->contents.rest(text, line_->now_s); }

    void choose(BrailleUse use) override { line_->use = use; }

    [[nodiscard]] std::optional<LineEvent> next_event() override;

    [[nodiscard]] bool is_there() const override { return line_->is_plugged_in; }

    [[nodiscard]] std::string take_report() override { return {}; }

    void forget() override;

  private:
    std::shared_ptr<ReadLine> line_;
};

}  // namespace touchline
