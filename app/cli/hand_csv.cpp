#include "app/cli/hand_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double largest_m = 1.0;
constexpr double largest_rad = 1000.0;
constexpr std::array<std::string_view, 4> names_of{"t_s", "x_m", "y_m", "angle_rad"};

std::span<const std::string_view> names_of_columns(HandColumns wanted) {
    return std::span(names_of).first(wanted == HandColumns::place ? 3 : 4);
}

/// Where each wanted column stands, in the order of their names.
using Columns = std::vector<std::size_t>;

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

Result<Columns> columns(std::string_view header, std::span<const std::string_view> wanted) {
    const auto names = fields(header);
    Columns at;
    for (const std::string_view name : wanted) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            return failure(fmt::format("line 1: no column {}; the first line must name {}", name,
                                       fmt::join(wanted, ",")));
        }
        at.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    return at;
}

Result<HandRow> row(std::string_view line, const Columns& at, std::size_t number_of) {
    const auto values = fields(line);
    std::array<double, names_of.size()> read{};
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= values.size()) {
            return failure(fmt::format("line {}: column {} is missing", number_of, names_of[i]));
        }
        const auto value = number(values[at[i]]);
        if (!value) {
            return failure(
                fmt::format("line {}: {} is not a finite number", number_of, names_of[i]));
        }
        read[i] = *value;
    }
    if (std::abs(read[1]) > largest_m || std::abs(read[2]) > largest_m) {
        return failure(fmt::format("line {}: more than 1 m from the centre; coordinates are metres",
                                   number_of));
    }
    if (std::abs(read[3]) > largest_rad) {
        return failure(fmt::format("line {}: more than 1000 rad; angles are radians", number_of));
    }
    return HandRow{read[0], {read[1], read[2]}, read[3]};
}

}  // namespace

Result<std::vector<HandRow>> parse_hand_csv(std::string_view text, HandColumns wanted) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    const auto at = columns(take_until(text, '\n'), names_of_columns(wanted));
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
