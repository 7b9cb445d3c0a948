#include "audio-cues/words/language.h"

#include "audio-cues/cues/cue_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

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

constexpr int most_counted = 4;
/// As a share of the picture's area: from a half on, "most" is true.
constexpr double most_from = 0.5;
/// As a share of the picture's width: things that span three of the five columns are in none of
/// them.
constexpr double across_from = 0.6;
constexpr int columns = 5;
/// As shares of the picture's height: the middle row is a little higher than the others, so that a
/// thing only somewhat off the middle is not said to be at the top or at the bottom.
constexpr double top_until = 0.3;
constexpr double bottom_from = 0.7;

struct ThingText {
    const char* one;
    const char* many;
};

/// The texts are in the order of ThingName.
constexpr std::array<ThingText, thing_name_count> texts{{{"a person", "{0} people"},
                                                         {"a bicycle", "{0} bicycles"},
                                                         {"a car", "{0} cars"},
                                                         {"a motorcycle", "{0} motorcycles"},
                                                         {"an aeroplane", "{0} aeroplanes"},
                                                         {"a bus", "{0} buses"},
                                                         {"a train", "{0} trains"},
                                                         {"a lorry", "{0} lorries"},
                                                         {"a boat", "{0} boats"},
                                                         {"a bird", "{0} birds"},
                                                         {"a cat", "{0} cats"},
                                                         {"a dog", "{0} dogs"},
                                                         {"a horse", "{0} horses"},
                                                         {"a sheep", "{0} sheep"},
                                                         {"a cow", "{0} cows"},
                                                         {"an elephant", "{0} elephants"},
                                                         {"a bear", "{0} bears"},
                                                         {"a zebra", "{0} zebras"},
                                                         {"a giraffe", "{0} giraffes"},
                                                         {"a bench", "{0} benches"},
                                                         {"an umbrella", "{0} umbrellas"},
                                                         {"a chair", "{0} chairs"},
                                                         {"a sofa", "{0} sofas"},
                                                         {"a potted plant", "{0} potted plants"},
                                                         {"a bed", "{0} beds"},
                                                         {"a table", "{0} tables"},
                                                         {"a screen", "{0} screens"},
                                                         {"a refrigerator", "{0} refrigerators"},
                                                         {"an animal", "{0} animals"},
                                                         {"a vehicle", "{0} vehicles"}}};

/// The rows go from the top, the columns from the left.
constexpr std::array<std::array<const char*, columns>, 3> place_texts{
    {{"at the top left", "at the top, left of the middle", "at the top",
      "at the top, right of the middle", "at the top right"},
     {"on the left", "left of the middle", "in the middle", "right of the middle", "on the right"},
     {"at the bottom left", "at the bottom, left of the middle", "at the bottom",
      "at the bottom, right of the middle", "at the bottom right"}}};

/// All things with one name.
struct Group {
    ThingName name;
    ThingBox box;  // around all of them
    double largest_area = 0.0;
    int count = 1;
};

std::vector<Group> groups_of(std::span<const NamedThing> things) {
    std::vector<Group> groups;
    for (const NamedThing& thing : things) {
        const auto at = std::ranges::find(groups, thing.name, &Group::name);
        if (at == groups.end()) {
            groups.push_back({thing.name, thing.box, area_of(thing.box)});
        } else {
            at->box = around(at->box, thing.box);
            at->largest_area = std::max(at->largest_area, area_of(thing.box));
            ++at->count;
        }
    }
    return groups;
}

/// Returns the words for the middle of the box, or for how much of the picture the largest thing
/// covers.
std::string place_of(const ThingBox& box, double largest_area, const Language& language) {
    if (largest_area >= most_from) return language.text("thing place", "in most of the picture");
    const double x = (box.left + box.right) / 2.0;
    const double y = (box.top + box.bottom) / 2.0;
    const std::size_t row = y < top_until ? 0 : y <= bottom_from ? 1 : 2;
    const auto column = static_cast<std::size_t>(std::clamp(x * columns, 0.0, columns - 1.0));
    return language.text("thing place", place_texts[row][column]);
}

std::string place_of(const Group& group, const Language& language) {
    const bool is_across = group.count > 1 && group.box.right - group.box.left >= across_from;
    if (is_across) return language.text("thing place", "across the picture");
    return place_of(group.box, group.largest_area, language);
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

std::string words_of(Place place, const Language& language) {
    // In the order of Place.
    static constexpr std::array names{"upper left", "top",    "upper right",
                                      "left",       "middle", "right",
                                      "lower left", "bottom", "lower right"};
    return language.text("place", names[static_cast<std::size_t>(place)]);
}

std::string words_of(Cue cue, const Language& language) {
    return language.text("sound", std::string(row_of(cue).name));
}

std::string words_of(ThingName name, int count, const Language& language) {
    const ThingText& text = texts[static_cast<std::size_t>(name)];
    const std::string counted =
        language.counted("thing", text.one, text.many, std::min(count, most_counted));
    return count < most_counted ? counted : language.text("things", "{0} or more", {counted});
}

std::string words_of(const ThingBox& box, const Language& language) {
    return place_of(box, area_of(box), language);
}

std::string words_of(std::span<const NamedThing> things, const Language& language) {
    std::string words;
    for (const Group& group : groups_of(things)) {
        const char* sentence = words.empty() ? "Probably {0}, {1}." : "And probably {0}, {1}.";
        if (!words.empty()) words += ' ';
        words +=
            language.text("things", sentence,
                          {words_of(group.name, group.count, language), place_of(group, language)});
    }
    return words;
}

}  // namespace touchline
