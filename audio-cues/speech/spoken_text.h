// Words to be said, some of which somebody recorded: a text is said in pieces, each a recording or
// words for the voice. Threads: values and pure functions.
#pragma once

#include "audio-cues/speech/recording.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// The bytes from `begin` up to, but without, `end` of a text are what the recording says.
struct RecordedSpan {
    std::size_t begin = 0;
    std::size_t end = 0;
    VoiceRecordingPtr recording;

    friend bool operator==(const RecordedSpan&, const RecordedSpan&) = default;
};

/// A text, and what of it is recorded. Any text is one that nobody recorded.
struct SpokenText {
    SpokenText() = default;

    SpokenText(const char* text) : words(text) {}

    SpokenText(std::string text) : words(std::move(text)) {}

    /// `recording`: of the whole text; null: nobody recorded it.
    SpokenText(std::string text, VoiceRecordingPtr recording) : words(std::move(text)) {
        if (recording) recorded.push_back({0, words.size(), std::move(recording)});
    }

    std::string words;
    std::vector<RecordedSpan> recorded;  // in order

    friend bool operator==(const SpokenText&, const SpokenText&) = default;
};

/// What is said in one go: the recording, or, if that is null, the words by the voice.
struct SpeechPiece {
    std::string words;
    VoiceRecordingPtr recording;

    friend bool operator==(const SpeechPiece&, const SpeechPiece&) = default;
};

/// Cuts the text where recordings begin and end. Between them the words for the voice begin with no
/// stop, comma or blank, and have a letter or a digit. A span that lies outside the text, overlaps
/// an earlier one or has no samples is left to the voice. A text without spans is one piece, as it
/// is. O(length).
[[nodiscard]] std::vector<SpeechPiece> pieces_of(const SpokenText& text);

}  // namespace touchline
