#include "app/documents/packs/curator_texts.h"

#include "app/documents/decode/one_line.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr std::string_view line_blanks = " \t\r";

/// Splits off the first line.
std::string_view take_line(std::string_view& text) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

bool is_going_on(std::string_view line) {
    return line.starts_with(' ') || line.starts_with('\t');
}

/// Adds a line that is no comment. Returns what is wrong with it; empty: nothing.
std::string add_line(std::string_view line, int number, std::vector<CuratorLine>& lines) {
    if (is_going_on(line) && !lines.empty()) {
        lines.back().value += ' ';
        lines.back().value += trimmed(line, line_blanks);
        return {};
    }
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) return "there is no colon; write it as “title: A boat”";
    std::string key = one_spaced(trimmed(line.substr(0, colon), line_blanks), 200);
    const auto is_same = [&key](const CuratorLine& each) { return each.key == key; };
    if (std::ranges::any_of(lines, is_same)) return fmt::format("“{}” is there twice", key);
    lines.push_back(
        {number, std::move(key), std::string(trimmed(line.substr(colon + 1), line_blanks))});
    return {};
}

}  // namespace

std::string curator_fault(const std::string& name, int line, std::string_view what) {
    return line > 0 ? fmt::format("{}, line {}: {}", name, line, what)
                    : fmt::format("{}: {}", name, what);
}

CuratorTexts curator_texts(const std::string& name, std::span<const std::byte> bytes) {
    std::string_view text = as_text(bytes);
    CuratorTexts texts;
    if (!is_utf8(text)) {
        texts.faults.push_back(curator_fault(name, 0, "this is no UTF-8 text; save it as one"));
        return texts;
    }
    constexpr std::string_view mark = "\xef\xbb\xbf";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = take_line(text);
        if (trimmed(line, line_blanks).empty() || line.starts_with('#')) continue;
        const std::string wrong = add_line(line, number, texts.lines);
        if (!wrong.empty()) texts.faults.push_back(curator_fault(name, number, wrong));
    }
    for (CuratorLine& each : texts.lines) {
        each.value = one_spaced(trimmed(each.value, line_blanks), longest_curator_bytes + 1);
        if (each.value.empty())
            texts.faults.push_back(curator_fault(
                name, each.line, fmt::format("“{}” has no text; write one behind it", each.key)));
        if (each.value.size() > longest_curator_bytes)
            texts.faults.push_back(curator_fault(
                name, each.line, fmt::format("“{}” is too long; shorten it", each.key)));
    }
    std::erase_if(texts.lines, [](const CuratorLine& each) { return each.value.empty(); });
    return texts;
}

}  // namespace touchline
