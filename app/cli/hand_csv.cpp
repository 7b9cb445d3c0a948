#include "app/cli/hand_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/core.h>

namespace touchline {
namespace {

constexpr double largest_m = 1.0;
constexpr std::array<std::string_view, 3> wanted{"t_s", "x_m", "y_m"};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// Takes the part of `rest` before the separator off its front.
std::string_view take_until(std::string_view& rest, char separator) {
    const auto end = std::min(rest.find(separator), rest.size());
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return part;
}

std::vector<std::string_view> fields(std::string_view line) {
    std::vector<std::string_view> out;
    const bool ends_empty = line.ends_with(',');
    while (!line.empty()) out.push_back(trimmed(take_until(line, ',')));
    if (ends_empty) out.emplace_back();
    return out;
}

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

/// Where each wanted column stands.
Result<std::array<std::size_t, 3>> columns(std::string_view header) {
    const auto names = fields(header);
    std::array<std::size_t, 3> at{};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto found = std::find(names.begin(), names.end(), wanted[i]);
        if (found == names.end()) {
            return failure(fmt::format("line 1: no column {}; the first line must name t_s,x_m,y_m",
                                       wanted[i]));
        }
        at[i] = static_cast<std::size_t>(found - names.begin());
    }
    return at;
}

Result<HandRow> row(std::string_view line, const std::array<std::size_t, 3>& at,
                    std::size_t number_of) {
    const auto values = fields(line);
    std::array<double, 3> read{};
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= values.size()) {
            return failure(fmt::format("line {}: column {} is missing", number_of, wanted[i]));
        }
        const auto value = number(values[at[i]]);
        if (!value) {
            return failure(fmt::format("line {}: {} is not a finite number", number_of, wanted[i]));
        }
        read[i] = *value;
    }
    if (std::abs(read[1]) > largest_m || std::abs(read[2]) > largest_m) {
        return failure(fmt::format("line {}: more than 1 m from the centre; coordinates are metres",
                                   number_of));
    }
    return HandRow{read[0], {read[1], read[2]}};
}

}  // namespace

Result<std::vector<HandRow>> parse_hand_csv(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const auto at = columns(take_until(text, '\n'));
    if (!at) return tl::unexpected(at.error());
    std::vector<HandRow> rows;
    for (std::size_t line = 2; !text.empty(); ++line) {
        const std::string_view content = trimmed(take_until(text, '\n'));
        if (content.empty()) continue;
        const auto next = row(content, *at, line);
        if (!next) return tl::unexpected(next.error());
        if (!rows.empty() && !(next->t_s > rows.back().t_s)) {
            return failure(fmt::format("line {}: t_s does not increase", line));
        }
        rows.push_back(*next);
    }
    if (rows.empty()) return failure("no rows; each row is one step of the hand");
    return rows;
}

}  // namespace touchline
