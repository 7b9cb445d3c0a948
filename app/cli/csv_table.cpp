#include "app/cli/csv_table.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr std::string_view separators = ",;\t";

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

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
        std::string field(trimmed(rest_.substr(0, size)));
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

bool is_utf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    return text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');
}

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

}  // namespace touchline
