#include "app/cli/hand_csv.h"

#include "app/cli/csv_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double largest_m = 1.0;
constexpr double largest_rad = 1000.0;
constexpr std::array<std::string_view, 4> names_of{"t_s", "x_m", "y_m", "angle_rad"};

std::span<const std::string_view> names_of_columns(HandColumns wanted) {
    return std::span(names_of).first(wanted == HandColumns::place ? 3 : 4);
}

/// The index of each required column, in the order of their names.
using Columns = std::vector<std::size_t>;

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

bool has_decimal_comma(std::string_view text) {
    return std::ranges::count(text, ',') == 1 && text.find('.') == std::string_view::npos;
}

std::string with_point(std::string text) {
    std::ranges::replace(text, ',', '.');
    return text;
}

Result<Columns> columns(const CsvRow& header, std::span<const std::string_view> wanted) {
    Columns at;
    for (const std::string_view name : wanted) {
        const auto found = std::ranges::find(header.fields, name);
        if (found == header.fields.end()) {
            return failure(fmt::format("line {}: no column {}; the first line must name {}",
                                       header.line, name, fmt::join(wanted, ",")));
        }
        if (std::ranges::count(header.fields, name) > 1)
            return failure(fmt::format("line {}: two columns are called {}", header.line, name));
        at.push_back(static_cast<std::size_t>(found - header.fields.begin()));
    }
    return at;
}

class HandReader {
  public:
    HandReader(const CsvTable& table, Columns at) : table_(table), at_(std::move(at)) {}

    [[nodiscard]] Result<HandRow> row(const CsvRow& row) const {
        if (auto sound = has_its_columns(row); !sound) return tl::unexpected(sound.error());
        std::array<double, names_of.size()> read{};
        for (std::size_t i = 0; i < at_.size(); ++i) {
            const auto value = value_of(row.fields[at_[i]]);
            if (!value) return no_number(row, i);
            read[i] = *value;
        }
        if (std::abs(read[1]) > largest_m || std::abs(read[2]) > largest_m) {
            return failure(fmt::format(
                "line {}: more than 1 m from the centre; coordinates are metres", row.line));
        }
        if (std::abs(read[3]) > largest_rad) {
            return failure(
                fmt::format("line {}: more than 1000 rad; angles are radians", row.line));
        }
        return HandRow{read[0], {read[1], read[2]}, read[3]};
    }

  private:
    /// A value cut in two by its decimal comma must not count as two.
    [[nodiscard]] Result<void> has_its_columns(const CsvRow& row) const {
        const std::size_t named = table_.rows.front().fields.size();
        for (std::size_t i = 0; i < at_.size(); ++i)
            if (at_[i] >= row.fields.size())
                return failure(fmt::format("line {}: column {} is missing", row.line, names_of[i]));
        const auto last =
            std::ranges::find_if_not(row.fields.rbegin(), row.fields.rend(), &std::string::empty);
        const auto filled = static_cast<std::size_t>(row.fields.rend() - last);
        if (filled <= named) return {};
        return failure(fmt::format(
            "line {}: {} values, but the first line names {} columns; numbers need a decimal point",
            row.line, filled, named));
    }

    /// If commas separate the values, no number holds one.
    [[nodiscard]] std::optional<double> value_of(const std::string& field) const {
        if (table_.separator != ',' && has_decimal_comma(field)) return number(with_point(field));
        return number(field);
    }

    [[nodiscard]] tl::unexpected<Error> no_number(const CsvRow& row, std::size_t column) const {
        const std::string& field = row.fields[at_[column]];
        const bool is_comma = has_decimal_comma(field) && number(with_point(field));
        return failure(fmt::format("line {}: {} is not a finite number{}", row.line,
                                   names_of[column],
                                   is_comma ? "; write " + with_point(field) + " for it" : ""));
    }

    const CsvTable& table_;
    Columns at_;
};

}  // namespace

Result<std::vector<HandRow>> parse_hand_csv(std::string_view text, HandColumns wanted) {
    const auto table = csv_table(text);
    if (!table) return tl::unexpected(table.error());
    const CsvRow nothing;
    const auto at =
        columns(table->rows.empty() ? nothing : table->rows.front(), names_of_columns(wanted));
    if (!at) return tl::unexpected(at.error());
    const HandReader reader(*table, *at);
    std::vector<HandRow> rows;
    for (const CsvRow& line : std::span(table->rows).subspan(1)) {
        const auto next = reader.row(line);
        if (!next) return tl::unexpected(next.error());
        if (!rows.empty() && !(next->t_s > rows.back().t_s)) {
            return failure(fmt::format("line {}: t_s does not increase", line.line));
        }
        rows.push_back(*next);
    }
    if (rows.empty()) return failure("no rows; each row is one step of the hand");
    return rows;
}

}  // namespace touchline
