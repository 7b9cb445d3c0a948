#include "audio-cues/words/guidance_words.h"

#include "audio-cues/cues/cue_table.h"

#include <array>

namespace touchline {
namespace {

std::string distance_words(int distance_mm, const Language& language) {
    if (distance_mm < 10) {
        return language.counted("count", "{0} millimetre", "{0} millimetres", distance_mm);
    }
    return language.counted("count", "{0} centimetre", "{0} centimetres", (distance_mm + 5) / 10);
}

}  // namespace

std::string words_of(Place place, const Language& language) {
    // In the order of Place.
    static constexpr std::array names{"upper left", "top",    "upper right",
                                      "left",       "middle", "right",
                                      "lower left", "bottom", "lower right"};
    return language.text("place", names[static_cast<std::size_t>(place)]);
}

std::string words_of(const ClockFace& way, const Language& language) {
    if (way.distance_mm <= 0) return language.text("guidance", "You are there.");
    const std::string distance = distance_words(way.distance_mm, language);
    if (way.hour == 1) return language.text("guidance", "{0}, at one o’clock", {distance});
    return language.text("guidance", "{0}, at {1} o’clock", {distance, std::to_string(way.hour)});
}

std::string words_of(Cue cue, const Language& language) {
    return language.text("sound", std::string(row_of(cue).name));
}

}  // namespace touchline
