#include "app/house/change_lists.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::string_view journal_line = "Touchline change 1";
constexpr std::string_view record_line = "Touchline applied 1";
constexpr std::size_t longest_list_bytes = std::size_t{1} << 20U;

std::vector<std::string_view> words_of_line(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

/// The lines of such a file behind its first; nothing if it is another.
std::optional<std::vector<std::vector<std::string_view>>> list_in(std::string_view text,
                                                                  std::string_view first) {
    if (text.size() > longest_list_bytes || !text.ends_with('\n')) return std::nullopt;
    std::vector<std::vector<std::string_view>> lines;
    for (bool is_first = true; !text.empty(); is_first = false) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(line.size() + 1);
        if (is_first && line != first) return std::nullopt;
        if (!is_first) lines.push_back(words_of_line(line));
    }
    return lines;
}

std::optional<HouseRoot> root_in(std::string_view word) {
    const auto at = std::ranges::find(house_root_words, word);
    if (at == house_root_words.end()) return std::nullopt;
    return static_cast<HouseRoot>(at - house_root_words.begin());
}

std::string_view word_of(HouseRoot root) {
    return house_root_words[static_cast<std::size_t>(root)];
}

}  // namespace

std::string incoming_name(std::uint64_t number, std::string_view name) {
    return fmt::format("{}in-{}-{}", beside_mark, number, name);
}

std::string outgoing_name(std::uint64_t number, std::string_view name) {
    return fmt::format("{}out-{}-{}", beside_mark, number, name);
}

bool is_listed_name(std::string_view name) {
    return !name.empty() && name.find_first_of(std::string_view("/ \n\0", 4)) == name.npos &&
           name != "." && name != "..";
}

std::string journal_text(const std::vector<Move>& moves) {
    std::string text = std::string(journal_line) + '\n';
    for (const Move& move : moves)
        text += fmt::format("{} {} {} {}\n", word_of(move.root), move.name,
                            move.incoming.empty() ? "-" : move.incoming, move.outgoing);
    return text;
}

std::optional<std::vector<Move>> moves_in(std::string_view text) {
    const auto lines = list_in(text, journal_line);
    if (!lines) return std::nullopt;
    std::vector<Move> moves;
    for (const auto& words : *lines) {
        const auto root = root_in(words.front());
        if (!root || words.size() != 4 ||
            !std::all_of(words.begin() + 1, words.end(), is_listed_name))
            return std::nullopt;
        moves.push_back({*root, std::string(words[1]),
                         words[2] == "-" ? std::string() : std::string(words[2]),
                         std::string(words[3])});
    }
    return moves;
}

std::string record_text(const ChangeRecord& record) {
    std::string text = fmt::format("{}\nchange {} {}\n", record_line, record.number, record.made_s);
    for (const ChangedThing& thing : record.things)
        text += fmt::format("{} {} {}\n", word_of(thing.root), thing.name,
                            thing.was_there ? "was" : "new");
    return text;
}

std::optional<ChangeRecord> record_in(std::string_view text) {
    const auto lines = list_in(text, record_line);
    if (!lines || lines->empty() || lines->front().size() != 3 || lines->front()[0] != "change")
        return std::nullopt;
    const auto number = number_in<std::uint64_t>(lines->front()[1]);
    const auto made_s = number_in<std::int64_t>(lines->front()[2]);
    if (!number || !made_s) return std::nullopt;
    ChangeRecord record{*number, *made_s, {}};
    for (const auto& words : std::span(*lines).subspan(1)) {
        const auto root = root_in(words.front());
        if (!root || words.size() != 3 || !is_listed_name(words[1])) return std::nullopt;
        record.things.push_back({*root, std::string(words[1]), words[2] == "was"});
    }
    return record;
}

}  // namespace touchline
