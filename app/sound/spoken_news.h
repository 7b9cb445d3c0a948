// What is said, and which sound is given, when something changes: the panel's words for a person
// who may not read them.
// Threads: values and pure functions.
#pragma once

#include "app/session/session.h"
#include "audio-cues/cues/screen_event.h"
#include "audio-cues/speech/speech_queue.h"
#include "audio-cues/words/language.h"
#include "config/types/force_status.h"

#include <optional>
#include <string>
#include <vector>

namespace touchline {

/// All that is watched for changes.
struct SpokenState {
    Session session;
    ForceStatus force;
    std::string device_words;  // what the person at the handle is to do; English
};

/// What changed from one to the other, in the order in which it is to be said. What only English
/// has (why a file cannot be opened, how to home the device) is said by the English voice.
[[nodiscard]] std::vector<Utterance> spoken_news(const SpokenState& before, const SpokenState& now,
                                                 const Language& language);

/// The sound of the change; nothing where it has none.
[[nodiscard]] std::optional<ScreenEvent> screen_event(const SpokenState& before,
                                                      const SpokenState& now);

/// A title as it is said: the name of a file by its parts, anything else as it stands.
[[nodiscard]] std::string spoken_title(const std::string& title);

/// What, why and what to do, and that exploring goes on; empty for none.
[[nodiscard]] std::string spoken_fault(Fault fault, const Language& language);

/// "Right: next picture. Left: previous picture. ..."
[[nodiscard]] std::string spoken_keys(const Language& language);

}  // namespace touchline
