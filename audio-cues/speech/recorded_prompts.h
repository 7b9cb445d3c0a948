// A human voice instead of the synthetic one, for the texts that somebody recorded.
// Threads: constant once read; any may ask.
#pragma once

#include "audio-cues/speech/speech_queue.h"
#include "config/types/result.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

class RecordedPrompts {
  public:
    /// None.
    RecordedPrompts() = default;

    /// Of FOLDER/LANGUAGE/index.txt: one prompt a line, a file of that folder (wav.h), a tab and
    /// the text that it says. A folder without languages has none. What cannot be used is left to
    /// the synthetic voice, and `problems` has one line for each.
    [[nodiscard]] static RecordedPrompts read(const std::string& folder,
                                              std::vector<std::string>& problems);

    /// One more, of a text in a language (code, as of Language), mono at frame_rate_Hz, full scale
    /// 1; it takes the place of an earlier one. Before others ask, or by the thread that asks.
    void add(std::string language, std::string text, std::vector<float> samples);

    /// Mono at frame_rate_Hz, of the whole text in that language; null where nobody recorded it.
    /// O(log prompts).
    [[nodiscard]] const std::vector<float>* of(const Utterance& utterance) const;

    [[nodiscard]] std::size_t size() const { return prompts_.size(); }

  private:
    std::map<std::pair<std::string, std::string>, std::vector<float>> prompts_;
};

}  // namespace touchline
