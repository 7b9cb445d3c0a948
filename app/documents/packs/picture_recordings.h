// What somebody recorded of the words of a picture. Threads: plain values.
#pragma once

#include "audio-cues/speech/recording.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// In one language. Null: nobody recorded it.
struct PictureRecordings {
    VoiceRecordingPtr title;
    VoiceRecordingPtr description;
    std::vector<std::pair<std::string, VoiceRecordingPtr>> parts;  // by the label, none null
};

using PictureRecordingsPtr = std::shared_ptr<const PictureRecordings>;

/// 0 for null.
[[nodiscard]] inline std::size_t bytes_of(const PictureRecordingsPtr& recordings) {
    const auto bytes = [](const VoiceRecordingPtr& recording) {
        return recording ? recording->samples.size() * sizeof(std::int16_t) : std::size_t{0};
    };
    if (!recordings) return 0;
    std::size_t all = bytes(recordings->title) + bytes(recordings->description);
    for (const auto& part : recordings->parts) all += bytes(part.second);
    return all;
}

}  // namespace touchline
