#include "app/braille/line_pages.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

bool has_dots(const BrailleCells& cells) {
    return std::ranges::any_of(cells, [](std::uint8_t cell) { return cell != 0; });
}

/// Whether something rests that the last text does not say anyway.
bool is_resting(const LineReading& reading) {
    return has_dots(reading.resting) &&
           (reading.texts.empty() || reading.texts.back() != reading.resting);
}

/// How many texts there are to read, with what rests.
std::size_t count_of(const LineReading& reading) {
    return reading.texts.size() + (is_resting(reading) ? 1 : 0);
}

const BrailleCells& text_at(const LineReading& reading, std::size_t at) {
    return at < reading.texts.size() ? reading.texts[at] : reading.resting;
}

/// The index of the page that has the cell.
std::size_t page_with(const std::vector<LinePage>& pages, std::size_t cell) {
    const auto after = std::ranges::upper_bound(pages, cell, {}, &LinePage::first);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - pages.begin() - 1, 0));
}

std::vector<LinePage> pages_at(const LineReading& reading, std::size_t at) {
    return pages_of(text_at(reading, at), std::max(reading.width, std::size_t{1}));
}

LineReading moved(LineReading reading, std::size_t at, std::size_t cell, double now_s) {
    reading.at = at;
    reading.cell = cell;
    reading.since_s = now_s;
    return reading;
}

/// Whether the last page of a text is on the line that another text waits behind.
bool is_text_waiting(const LineReading& reading) {
    if (reading.width == 0 || reading.at + 1 >= reading.texts.size()) return false;
    const auto pages = pages_at(reading, reading.at);
    return page_with(pages, reading.cell) + 1 == pages.size();
}

}  // namespace

std::vector<LinePage> pages_of(std::span<const std::uint8_t> cells, std::size_t width) {
    std::vector<LinePage> pages;
    const std::size_t end = cells.size();
    const auto is_blank = [&cells](std::size_t at) { return cells[at] == 0; };
    for (std::size_t at = 0;;) {
        while (at < end && is_blank(at)) ++at;
        if (at == end) break;
        std::size_t until = std::min(end, at + width);
        if (until < end && !is_blank(until)) {
            std::size_t blank = until;
            while (blank > at && !is_blank(blank - 1)) --blank;
            if (blank > at) until = blank;  // else a word wider than the line
        }
        const std::size_t next = until;
        while (until > at && is_blank(until - 1)) --until;
        pages.push_back({at, until - at});
        at = next;
    }
    if (pages.empty()) pages.push_back({0, 0});
    return pages;
}

BrailleCells shown_on(const LineReading& reading) {
    BrailleCells line(reading.width, 0);
    if (reading.width == 0 || reading.at >= count_of(reading)) return line;
    const BrailleCells& text = text_at(reading, reading.at);
    const auto pages = pages_at(reading, reading.at);
    const LinePage page = pages[page_with(pages, reading.cell)];
    std::copy_n(text.begin() + static_cast<std::ptrdiff_t>(page.first), page.count, line.begin());
    return line;
}

LineReading with_text(LineReading reading, BrailleCells cells, LineUse use, double now_s) {
    if (!has_dots(cells)) return reading;
    const bool is_again = !reading.texts.empty() && reading.texts.back() == cells;
    if (is_again && use == LineUse::after) return reading;
    if (is_again) reading.texts.pop_back();
    const bool is_nothing_read = reading.at >= reading.texts.size();
    reading.texts.push_back(std::move(cells));
    if (reading.texts.size() > most_line_texts) {
        reading.texts.pop_front();
        // Who reads the oldest text of all is moved to the next.
        if (reading.at == 0) reading.cell = 0;
        reading.at -= reading.at > 0 ? 1 : 0;
    }
    const std::size_t last = reading.texts.size() - 1;
    if (use == LineUse::now || is_nothing_read) return moved(std::move(reading), last, 0, now_s);
    return reading;
}

LineReading with_resting(LineReading reading, BrailleCells cells, double now_s) {
    if (reading.resting == cells) return reading;
    reading.resting = std::move(cells);
    if (reading.at < reading.texts.size()) return reading;
    const std::size_t count = count_of(reading);
    const std::size_t at = std::min(reading.at, count > 0 ? count - 1 : 0);
    return moved(std::move(reading), at, 0, now_s);
}

LineReading with_width(LineReading reading, std::size_t width, double now_s) {
    if (reading.width == width) return reading;
    reading.width = width;
    reading.since_s = now_s;
    return reading;
}

std::optional<LineReading> turned(LineReading reading, LineTurn turn, double now_s) {
    const std::size_t count = count_of(reading);
    if (reading.width == 0 || reading.at >= count) return std::nullopt;
    const std::size_t at = reading.at;
    const auto pages = pages_at(reading, at);
    const std::size_t page = page_with(pages, reading.cell);
    const auto to = [&](std::size_t text, std::size_t cell) {
        return std::optional(moved(std::move(reading), text, cell, now_s));
    };
    switch (turn) {
        case LineTurn::on:
            if (page + 1 < pages.size()) return to(at, pages[page + 1].first);
            if (at + 1 < count) return to(at + 1, 0);
            return std::nullopt;
        case LineTurn::back:
            if (page > 0) return to(at, pages[page - 1].first);
            if (at > 0) {
                const std::size_t last = pages_at(reading, at - 1).back().first;
                return to(at - 1, last);
            }
            return std::nullopt;
        case LineTurn::to_first:
            if (page > 0) return to(at, 0);
            return std::nullopt;
        case LineTurn::to_last:
            if (page + 1 < pages.size()) return to(at, pages.back().first);
            return std::nullopt;
    }
    return std::nullopt;
}

LineReading passed(LineReading reading, double now_s) {
    const auto due_s = next_due_s(reading);
    if (!due_s || now_s < *due_s) return reading;
    const std::size_t next = reading.at + 1;
    return moved(std::move(reading), next, 0, now_s);
}

std::optional<double> next_due_s(const LineReading& reading) {
    if (!is_text_waiting(reading)) return std::nullopt;
    const auto pages = pages_at(reading, reading.at);
    return reading.since_s + reading_s(pages.back().count);
}

}  // namespace touchline
