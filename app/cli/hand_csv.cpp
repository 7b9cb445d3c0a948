#include "app/cli/hand_csv.h"

#include "config/types/utf8.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::string_view separators = ",;\t";

/// The first separator outside of quotes in the first line that is not blank.
char separator_of(std::string_view text) {
    bool is_quoted = false;
    bool is_begun = false;
    for (const char c : text) {
        if (c == '"') is_quoted = !is_quoted;
        if (is_quoted) continue;
        if (separators.find(c) != std::string_view::npos) return c;
        if (c == '\n' || c == '\r') {
            if (is_begun) break;
        } else if (c != ' ') {
            is_begun = true;
        }
    }
    return ',';
}

class CsvReader {
  public:
    CsvReader(std::string_view text, char separator, std::size_t line)
        : rest_(text), line_(line), separator_(separator) {}

    Result<std::vector<CsvRow>> read() {
        std::vector<CsvRow> rows;
        while (!rest_.empty()) {
            CsvRow row{line_, {}};
            do {
                auto field = take_field();
                if (!field) return tl::unexpected(field.error());
                row.fields.push_back(std::move(*field));
            } while (take_separator());
            take_line_end();
            const bool is_blank = std::ranges::all_of(row.fields, &std::string::empty);
            if (!is_blank) rows.push_back(std::move(row));
        }
        return rows;
    }

  private:
    [[nodiscard]] bool is_at_end_of_field() const {
        return rest_.empty() || rest_[0] == separator_ || rest_[0] == '\n' || rest_[0] == '\r';
    }

    void skip_blanks() {
        while (!rest_.empty() && rest_[0] != separator_ && (rest_[0] == ' ' || rest_[0] == '\t'))
            rest_.remove_prefix(1);
    }

    Result<std::string> take_field() {
        skip_blanks();
        if (rest_.starts_with('"')) return take_quoted();
        std::size_t size = 0;
        while (size < rest_.size() && rest_[size] != separator_ && rest_[size] != '\n' &&
               rest_[size] != '\r')
            ++size;
        std::string field(trimmed(rest_.substr(0, size), " \t"));
        rest_.remove_prefix(size);
        return field;
    }

    Result<std::string> take_quoted() {
        const std::size_t begin = line_;
        rest_.remove_prefix(1);
        std::string field;
        while (true) {
            const std::size_t quote = rest_.find('"');
            if (quote == std::string_view::npos)
                return failure(fmt::format("line {}: a quote is never closed", begin));
            const std::string_view part = rest_.substr(0, quote);
            line_ += static_cast<std::size_t>(std::ranges::count(part, '\n'));
            field += part;
            rest_.remove_prefix(quote + 1);
            if (!rest_.starts_with('"')) break;
            field += '"';
            rest_.remove_prefix(1);
        }
        skip_blanks();
        if (!is_at_end_of_field())
            return failure(fmt::format("line {}: something stands after a closing quote", line_));
        return field;
    }

    bool take_separator() {
        if (rest_.empty() || rest_[0] != separator_) return false;
        rest_.remove_prefix(1);
        return true;
    }

    /// CR LF, LF or CR.
    void take_line_end() {
        if (rest_.empty()) return;
        rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
        ++line_;
    }

    std::string_view rest_;
    std::size_t line_;
    char separator_;
};

/// The separator in a spreadsheet's "sep=" line, with that line's length.
std::optional<std::pair<char, std::size_t>> said_separator(std::string_view text) {
    constexpr std::string_view begin = "sep=";
    if (!text.starts_with(begin) || text.size() <= begin.size()) return std::nullopt;
    const char separator = text[begin.size()];
    const std::size_t end = text.find('\n');
    const auto line = text.substr(0, end);
    const bool is_whole = line.size() <= begin.size() + 2;  // perhaps with a CR
    if (separators.find(separator) == std::string_view::npos || !is_whole) return std::nullopt;
    return std::pair{separator, end == std::string_view::npos ? text.size() : end + 1};
}

constexpr double largest_m = 1.0;
constexpr double largest_rad = 1000.0;
constexpr std::array<std::string_view, 4> names_of{"t_s", "x_m", "y_m", "angle_rad"};

std::span<const std::string_view> names_of_columns(HandColumns wanted) {
    return std::span(names_of).first(wanted == HandColumns::place ? 3 : 4);
}

/// The index of each required column, in the order of their names.
using Columns = std::vector<std::size_t>;

std::optional<double> number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto value = number_in<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
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

Result<CsvTable> csv_table(std::string_view text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (is_utf16(text)) return failure("line 1: this is UTF-16; save it as CSV in UTF-8");
    if (const std::size_t at = text.find('\0'); at != std::string_view::npos)
        return failure(fmt::format("line {}: this is no text; save it as CSV in UTF-8",
                                   1 + std::ranges::count(text.substr(0, at), '\n')));
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    CsvTable table;
    std::size_t line = 1;
    if (const auto said = said_separator(text)) {
        table.separator = said->first;
        text.remove_prefix(said->second);
        ++line;
    } else {
        table.separator = separator_of(text);
    }
    auto rows = CsvReader(text, table.separator, line).read();
    if (!rows) return tl::unexpected(rows.error());
    table.rows = std::move(*rows);
    return table;
}

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
