// The result of something that the operator ordered. Threads: a plain value.
#pragma once

#include "audio-cues/words/language.h"
#include "config/types/result.h"

#include <string>
#include <utility>

namespace touchline {

struct Outcome {
    std::string said;  // to the operator, in their language
    std::string line;  // for the log, with names of files; empty: it went well
};

/// `said`, or why it was not done: an English sentence of the catalogue.
[[nodiscard]] inline Outcome outcome_of(const Result<void>& done, std::string said,
                                        const char* why_not, const Language& language) {
    if (done) return {std::move(said), ""};
    return {language.text("operator", why_not), done.error().line};
}

}  // namespace touchline
