#include "audio-cues/words/language.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>

#include <boost/locale/gnu_gettext.hpp>
#include <boost/locale/message.hpp>
#include <fmt/format.h>

namespace touchline {
namespace {

using Messages = boost::locale::message_format<char>;

/// Returns `pattern` with its {n} replaced. Not fmt, because a mistake in a catalogue must not
/// throw.
std::string filled(std::string_view pattern, std::span<const std::string_view> values) {
    std::string text;
    while (!pattern.empty()) {
        const bool is_place = pattern.size() >= 3 && pattern[0] == '{' && pattern[2] == '}' &&
                              pattern[1] >= '0' &&
                              static_cast<std::size_t>(pattern[1] - '0') < values.size();
        if (is_place) {
            text += values[static_cast<std::size_t>(pattern[1] - '0')];
        } else {
            text += pattern[0];
        }
        pattern.remove_prefix(is_place ? 3 : 1);
    }
    return text;
}

bool is_code(const std::string& code) {
    return !code.empty() && code.size() <= 16 && std::all_of(code.begin(), code.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    });
}

Messages* messages_of(std::vector<char> bytes, const std::string& code) {
    boost::locale::gnu_gettext::messages_info info;
    info.language = code;
    info.encoding = "UTF-8";
    info.domains.emplace_back("touchline");
    info.paths.emplace_back(".");  // any path will do: the bytes are already here
    info.callback = [&bytes](const std::string&, const std::string&) { return bytes; };
    return boost::locale::gnu_gettext::create_messages_facet<char>(info);
}

}  // namespace

Language::Language() : words_(std::locale::classic()) {}

Result<Language> Language::load(const std::string& folder, const std::string& code) {
    Language language;
    if (code == "en") return language;
    if (!is_code(code)) return failure(fmt::format("{}: is not the code of a language.", code));
    const std::string path = fmt::format("{}/{}.mo", folder, code);
    std::ifstream file(path, std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    if (bytes.empty()) return failure(fmt::format("{}: cannot be read.", path));
    try {
        language.words_ = std::locale(std::locale::classic(), messages_of(std::move(bytes), code));
    } catch (const std::exception&) {
        return failure(fmt::format("{}: is no catalogue of words; make it with msgfmt.", path));
    }
    language.code_ = code;
    if (language.name() == "English") {
        return failure(fmt::format("{}: does not say its language's name.", path));
    }
    return language;
}

std::string Language::text(const std::string& context, const std::string& english,
                           std::initializer_list<std::string_view> values) const {
    const char* found = nullptr;
    if (std::has_facet<Messages>(words_)) {
        found = std::use_facet<Messages>(words_).get(0, context.c_str(), english.c_str());
    }
    return filled(found != nullptr ? found : english.c_str(),
                  std::span(values.begin(), values.size()));
}

/// Returns the form for `count`, with its placeholder not yet filled.
std::string Language::form(const std::string& context, const std::string& one,
                           const std::string& many, int count) const {
    const char* found = nullptr;
    if (std::has_facet<Messages>(words_)) {
        found = std::use_facet<Messages>(words_).get(0, context.c_str(), one.c_str(), count);
    }
    if (found != nullptr) return found;
    return count == 1 ? one : many;
}

std::string Language::counted(const std::string& context, const std::string& one,
                              const std::string& many, int count) const {
    const std::string number = std::to_string(count);
    const std::string_view value = number;
    return filled(form(context, one, many, count), std::span(&value, 1));
}

std::string Language::measured(const std::string& context, const std::string& one,
                               const std::string& many, double value) const {
    const std::string digits = fmt::format("{:.6g}", value);
    double heard = value;  // 0.9999999 reads as 1
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), heard);
    const double whole = std::clamp(std::trunc(heard), -1e6, 1e6);
    const bool is_small_fraction = whole != heard && std::abs(heard) < 2.0;
    const std::string number = with_sign(digits);
    const std::string_view said = number;
    const int count = is_small_fraction ? 0 : static_cast<int>(whole);
    return filled(form(context, one, many, count), std::span(&said, 1));
}

std::string Language::with_sign(std::string digits) const {
    if (const auto point = digits.find('.'); point != std::string::npos) {
        digits.replace(point, 1, text("decimal", "."));
    }
    return digits;
}

std::string Language::number(double value, int decimals) const {
    return with_sign(fmt::format("{:.{}f}", value, std::clamp(decimals, 0, 6)));
}

/// A lone English "A" is an article to the voice, unless a pause follows.
std::string Language::respelling() const {
    return text("respelling",
                "letter A … = letter eh …; Letter A … = Letter eh …; A and = eh and; A or = eh or; "
                "A … = A …; A = eh");
}

double Language::pace() const {
    const std::string percent = text("pace", "100");
    int value = 0;
    (void)std::from_chars(percent.data(), percent.data() + percent.size(), value);
    return value >= 50 && value <= 200 ? value / 100.0 : 1.0;
}

Result<std::vector<std::string>> languages_in(const std::string& folder) {
    std::vector<std::string> codes;
    std::error_code problem;
    for (std::filesystem::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const auto& path = entry->path();
        if (path.extension() == ".mo" && is_code(path.stem().string())) {
            codes.push_back(path.stem().string());
        }
    }
    if (problem) return failure(fmt::format("{}: cannot be read: {}.", folder, problem.message()));
    std::sort(codes.begin(), codes.end());
    codes.insert(codes.begin(), "en");
    return codes;
}

}  // namespace touchline
