#include "tests/lab/bench/curve/report.h"

#include "app/documents/decode/files.h"

#include <sstream>

namespace touchline::bench {
namespace {

constexpr std::size_t columns = 110;

std::string joined(const std::vector<std::string>& cells, const char* between) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : between) + cell;
    return line;
}

std::string wrapped(const std::string& paragraph) {
    std::istringstream words(paragraph);
    std::string out;
    std::size_t length = 0;
    for (std::string word; words >> word; length += word.size()) {
        if (length > 0) {
            const bool is_full = length + 1 + word.size() > columns;
            out += is_full ? '\n' : ' ';
            length = is_full ? 0 : length + 1;
        }
        out += word;
    }
    return out;
}

}  // namespace

std::string Table::csv() const {
    std::string text = joined(header, ",") + '\n';
    for (const auto& row : rows) text += joined(row, ",") + '\n';
    return text;
}

std::string Table::markdown() const {
    std::string text = "| " + joined(header, " | ") + " |\n|";
    for (std::size_t i = 0; i < header.size(); ++i) text += i == 0 ? "---|" : "---:|";
    text += '\n';
    for (const auto& row : rows) text += "| " + joined(row, " | ") + " |\n";
    return text;
}

Result<void> write_csv(const Folders& folders, const std::string& name, const Table& table) {
    return write_whole_file(folders.work + "/" + name + ".csv", table.csv());
}

Result<void> write_words(const Folders& folders, const std::string& name, const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) {
        out += (line.empty() || line.front() == '|' ? line : wrapped(line)) + '\n';
    }
    return write_whole_file(folders.work + "/" + name + ".md", out);
}

std::string list_in_words(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
        text += items[i];
    }
    return text;
}

}  // namespace touchline::bench
