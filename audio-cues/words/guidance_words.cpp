#include "audio-cues/words/guidance_words.h"

#include "audio-cues/cues/cue_table.h"

#include <array>

namespace touchline {

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

}  // namespace touchline
