#include "app/decode/reading_order.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace touchline {
namespace {

struct Words {
    WrittenLanguage language;
    std::string_view iso;
    std::string_view code;
    std::string_view name;
};

constexpr std::array all{Words{WrittenLanguage::english, "en", "eng", "English"},
                         Words{WrittenLanguage::german, "de", "deu", "German"},
                         Words{WrittenLanguage::french, "fr", "fra", "French"},
                         Words{WrittenLanguage::spanish, "es", "spa", "Spanish"},
                         Words{WrittenLanguage::italian, "it", "ita", "Italian"}};

const Words& words_of(WrittenLanguage language) {
    return all[static_cast<std::size_t>(language)];
}

}  // namespace

std::string_view name_of(WrittenLanguage language) {
    return words_of(language).name;
}

WrittenLanguage written_language(std::string_view code) {
    const auto* const found = std::ranges::find(all, code, &Words::iso);
    return found == all.end() ? WrittenLanguage::english : found->language;
}

std::string_view code_of(WrittenLanguage language) {
    return words_of(language).code;
}

std::vector<std::string> arguments_of(const ReadingOrder& order) {
    std::vector<std::string> arguments;
    for (const WrittenLanguage language : order.languages)
        arguments.emplace_back(code_of(language));
    return arguments;
}

Result<ReadingOrder> reading_order_in(std::span<const std::string> arguments) {
    ReadingOrder order{{}};
    for (const std::string& argument : arguments) {
        const auto* const found = std::ranges::find(all, argument, &Words::code);
        if (found == all.end() || std::ranges::count(order.languages, found->language) > 0)
            return failure("not what the kiosk starts it with");
        order.languages.push_back(found->language);
    }
    if (order.languages.empty()) return failure("not what the kiosk starts it with");
    return order;
}

}  // namespace touchline
