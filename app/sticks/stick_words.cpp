#include "app/sticks/stick_words.h"

namespace touchline {
namespace {

void add(std::string& text, const std::string& sentences) {
    if (!text.empty()) text += ' ';
    text += sentences;
}

/// One sentence per reason about folders, because each has another remedy.
void add_folders(std::string& text, const StickRest& rest, const Language& language) {
    const auto say = [&](const char* english) { add(text, language.text("stick", english)); };
    if (rest.has_deeper)
        say("Folders within eight others were left out. Put their files nearer to the top.");
    if (rest.has_unreadable)
        say("Some folders could not be read. Copy their files to another USB stick.");
    if (rest.is_cut_short)
        say("There was no time for all folders. Put other files outside of all folders.");
}

}  // namespace

std::string words_of(const StickRest& rest, std::size_t listed, const Language& language) {
    std::string text;
    if (rest.not_listed > 0) {
        add(text, language.text(
                      "stick", "The list has {0} files of {1}. For others, bring fewer at a time.",
                      {std::to_string(listed), std::to_string(listed + rest.not_listed)}));
    }
    add_folders(text, rest, language);
    return text;
}

std::string nothing_words(const StickRest& rest, const Language& language) {
    std::string text = language.text(
        "stick", "There is no picture or PDF on the USB stick. Put some on it and bring it again.");
    add_folders(text, rest, language);
    return text;
}

}  // namespace touchline
