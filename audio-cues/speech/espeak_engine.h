// The voice itself, espeak-ng: text in, samples out. Untrusted texts reach its C code here, so it
// runs in a process of its own (app/sound/speak). Threads: one; one engine per process, because its
// state is global.
#pragma once

#include "audio-cues/speech/speech_input.h"
#include "config/types/result.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace touchline {

/// Receives samples at EspeakEngine::rate_Hz, full scale 32767; returning false stops the speech.
using SpeechSink = std::function<bool(std::span<const std::int16_t>)>;

class EspeakEngine {
  public:
    static constexpr int rate_Hz = 22050;

    /// Reads everything the voice needs (a language of espeak-ng: "en", "fr-fr"). The engine speaks
    /// without an audio device and never ends the process. Fails with one line if the library or
    /// the voice is missing.
    [[nodiscard]] static Result<EspeakEngine> start(const std::string& voice);

    /// Passes on pieces of at most 20 ms as they are made: 5 s take 6 ms. Returns after the last
    /// piece, or once the sink returned false. Markup and phonemes in the text are read as text;
    /// see plain_text().
    void speak(const std::string& text, const EngineRate& rate, const SpeechSink& sink);

  private:
    EspeakEngine() = default;
};

}  // namespace touchline
