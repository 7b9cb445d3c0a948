#include "tests/audio-cues/words/po_file.h"

#include <fstream>

namespace touchline {
namespace {

/// Returns the text between the quotes of a line, with escapes resolved.
std::string unquoted(const std::string& line) {
    const auto begin = line.find('"');
    const auto end = line.rfind('"');
    std::string text;
    for (auto i = begin + 1; begin != std::string::npos && i < end; ++i) {
        if (line[i] == '\\') {
            ++i;
            text += line[i] == 'n' ? '\n' : line[i];
        } else {
            text += line[i];
        }
    }
    return text;
}

struct Reading {
    PoFile file;
    std::string context;
    std::string english;
    PoEntry entry;
    bool has_entry = false;

    void finish() {
        if (has_entry) file[{context, english}] = entry;
        context.clear();
        english.clear();
        entry = {};
        has_entry = false;
    }
};

}  // namespace

std::size_t plural_forms(const PoFile& file) {
    const std::string key = "nplurals=";
    const auto head = file.find({"", ""});
    if (head == file.end()) return 2;
    const std::string& text = head->second.said.front();
    const auto at = text.find(key);
    return at == std::string::npos ? 2 : std::stoul(text.substr(at + key.size()));
}

PoFile read_po(const std::string& path) {
    std::ifstream lines(path);
    Reading reading;
    std::string* current = nullptr;
    for (std::string line; std::getline(lines, line);) {
        const auto begins = [&line](const char* word) { return line.rfind(word, 0) == 0; };
        if (line.empty()) {
            reading.finish();
        } else if (begins("#,")) {
            reading.entry.is_doubtful = line.find("fuzzy") != std::string::npos;
        } else if (begins("msgctxt")) {
            current = &reading.context;
            *current = unquoted(line);
        } else if (begins("msgid_plural")) {
            current = &reading.entry.plural;
            *current = unquoted(line);
        } else if (begins("msgid")) {
            current = &reading.english;
            *current = unquoted(line);
        } else if (begins("msgstr")) {
            current = &reading.entry.said.emplace_back(unquoted(line));
            reading.has_entry = true;
        } else if (begins("\"") && current != nullptr) {
            *current += unquoted(line);
        }
    }
    reading.finish();
    return reading.file;
}

}  // namespace touchline
