// What a visitor hears in a whole visit, as a text for people to review, and what it must never
// contain. Threads: values and pure functions.
#pragma once

#include "tests/audio-cues/words/po_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace touchline {

struct TranscriptLine {
    double at_s = 0.0;
    double end_s = 0.0;    // end of the speech
    std::string language;  // code; empty: a stage direction
    std::string text;      // if the speech was cut: what was heard
    bool is_cut = false;
    bool is_asked = false;  // a key asked for these words
};

/// What was said and what the visitor did, in order.
using Transcript = std::vector<TranscriptLine>;

/// Returns each sentence, with the stop that ends it.
[[nodiscard]] std::vector<std::string> sentences_of(std::string_view text);

/// Returns one line for each sentence and each stage direction; the first line of each speech has
/// its time. Words in another language than `language` begin with its code.
[[nodiscard]] std::string text_of(const Transcript& transcript, std::string_view language);

/// Returns sentences that are said again within ten seconds though no key asked for them, or twice
/// in one speech, each with its time.
[[nodiscard]] std::vector<std::string> said_twice(const Transcript& transcript);

/// Returns English sentences where the visit's language has other words; `catalogue` is that
/// language's.
[[nodiscard]] std::vector<std::string> left_in_english(const Transcript& transcript,
                                                       std::string_view language,
                                                       const PoFile& catalogue);

}  // namespace touchline
