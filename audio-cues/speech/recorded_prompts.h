// A human voice instead of the synthetic one, for the texts that somebody recorded.
// Threads: constant once read; any may ask. Pure functions, except for reading files.
#pragma once

#include "audio-cues/speech/speech_queue.h"
#include "config/types/result.h"

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// Decodes a WAV of 16-bit PCM, mono or stereo (mixed down), at 48 000 or 22 050 Hz and at most 60
/// s, to mono at frame_rate_Hz, full scale 1. Anything else gives a one-line error.
[[nodiscard]] Result<std::vector<float>> decode_wav(std::span<const char> bytes);

class RecordedPrompts {
  public:
    /// Has no prompts.
    RecordedPrompts() = default;

    /// Reads FOLDER/LANGUAGE/index.txt: one prompt a line, with a file of that folder (a WAV), a
    /// tab and the text that it speaks. A folder without languages has no prompts. Unusable prompts
    /// are left to the synthetic voice, and `problems` gets one line for each.
    [[nodiscard]] static RecordedPrompts read(const std::string& folder,
                                              std::vector<std::string>& problems);

    /// Adds a prompt for a text in a language (code, as of Language), mono at frame_rate_Hz, full
    /// scale 1; it replaces an earlier one. Call before others ask, or from the thread that asks.
    void add(std::string language, std::string text, std::vector<float> samples);

    /// Returns the recording of the whole text in that language, mono at frame_rate_Hz; null if
    /// nobody recorded it. O(log prompts).
    [[nodiscard]] const std::vector<float>* of(const Utterance& utterance) const;

    [[nodiscard]] std::size_t size() const { return prompts_.size(); }

  private:
    std::map<std::pair<std::string, std::string>, std::vector<float>> prompts_;
};

}  // namespace touchline
