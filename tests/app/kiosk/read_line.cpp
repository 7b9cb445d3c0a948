#include "tests/app/kiosk/read_line.h"

#include <utility>

#include <gtest/gtest.h>

namespace touchline {
namespace {

std::string ascii_of(const BrailleCells& cells) {
    std::string text;
    for (const std::uint8_t cell : cells) text += braille_ascii(cell);
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

}  // namespace

std::string ReadLine::page() const {
    return ascii_of(contents.shown());
}

void ReadLine::turn(LineTurn turn) {
    events.emplace_back(LineTurned{!contents.turn(turn, now_s)});
}

std::string as_read(const std::string& words, const std::string& language) {
    const auto braille = braille_of(words, language, BrailleGrade::uncontracted);
    EXPECT_TRUE(braille) << words;
    return braille ? ascii_of(braille->cells) : std::string();
}

std::optional<LineEvent> ReadBraille::next_event() {
    // A moment of the line's own thread.
    line_->contents.set_width(line_->is_plugged_in ? ReadLine::width : 0, line_->now_s);
    line_->contents.pass(line_->now_s);
    if (line_->events.empty()) return std::nullopt;
    const LineEvent event = line_->events.front();
    line_->events.pop_front();
    return event;
}

void ReadBraille::forget() {
    line_->contents.forget();
    ++line_->forgotten;
}

}  // namespace touchline
