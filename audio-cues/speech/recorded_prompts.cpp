#include "audio-cues/speech/recorded_prompts.h"

#include "audio-cues/speech/resampler.h"
#include "audio-cues/synth/frames.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

namespace touchline {
namespace {

constexpr std::uint32_t engine_Hz = 22050;
constexpr std::size_t longest_s = 60;

std::uint32_t number_at(std::span<const char> bytes, std::size_t at, std::size_t size) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i) {
        number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8U * i);
    }
    return number;
}

/// Returns the contents of the chunk with that name; nothing if it is missing or cut short.
std::optional<std::span<const char>> chunk(std::span<const char> bytes, std::string_view name) {
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t size = number_at(bytes, at + 4, 4);
        if (size > bytes.size() - at - 8) return std::nullopt;
        if (std::string_view(&bytes[at], 4) == name) return bytes.subspan(at + 8, size);
        at += 8 + size + size % 2;
    }
    return std::nullopt;
}

Result<std::vector<float>> read_wav(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    auto samples = decode_wav(bytes);
    if (!samples) return failure(path + ": " + samples.error().line);
    return samples;
}

}  // namespace

Result<std::vector<float>> decode_wav(std::span<const char> bytes) {
    const bool is_wav = bytes.size() >= 12 && std::string_view(bytes.data(), 4) == "RIFF" &&
                        std::string_view(&bytes[8], 4) == "WAVE";
    const auto format = is_wav ? chunk(bytes, "fmt ") : std::nullopt;
    const auto data = is_wav ? chunk(bytes, "data") : std::nullopt;
    if (!format || format->size() < 16 || !data) return failure("is no whole WAV file.");
    const std::uint32_t channels = number_at(*format, 2, 2);
    const std::uint32_t rate_Hz = number_at(*format, 4, 4);
    const bool is_known =
        number_at(*format, 0, 2) == 1 && number_at(*format, 14, 2) == 16 &&
        (channels == 1 || channels == 2) &&
        (rate_Hz == engine_Hz || rate_Hz == static_cast<std::uint32_t>(frame_rate_Hz));
    if (!is_known) return failure("is not 16-bit PCM of one or two channels at 48000 or 22050 Hz.");
    const std::size_t frames = data->size() / (2 * channels);
    if (frames > longest_s * rate_Hz) return failure("is longer than a minute.");
    std::vector<float> mono;
    mono.reserve(frames);
    for (std::size_t i = 0; i < frames; ++i) {
        int sum = 0;
        for (std::size_t c = 0; c < channels; ++c) {
            sum += static_cast<std::int16_t>(number_at(*data, 2 * (i * channels + c), 2));
        }
        mono.push_back(of_full_scale(static_cast<std::int16_t>(sum / static_cast<int>(channels))));
    }
    return at_frame_rate(mono, static_cast<int>(rate_Hz));
}

RecordedPrompts RecordedPrompts::read(const std::string& folder,
                                      std::vector<std::string>& problems) {
    RecordedPrompts prompts;
    std::error_code missing;
    for (std::filesystem::directory_iterator entry(folder, missing), end; !missing && entry != end;
         entry.increment(missing)) {
        const std::string language = entry->path().filename().string();
        const std::string index = entry->path().string() + "/index.txt";
        std::ifstream lines(index);
        for (std::string line; std::getline(lines, line);) {
            const auto tab = line.find('\t');
            const std::string file = line.substr(0, tab);
            if (tab == std::string::npos || file.find('/') != std::string::npos) {
                problems.push_back(index + ": a line is not FILE, tab, text: " + line);
                continue;
            }
            auto samples = read_wav(entry->path().string() + "/" + file);
            if (samples) {
                prompts.prompts_[{language, line.substr(tab + 1)}] = std::move(*samples);
            } else {
                problems.push_back(samples.error().line);
            }
        }
    }
    return prompts;
}

void RecordedPrompts::add(std::string language, std::string text, std::vector<float> samples) {
    prompts_[{std::move(language), std::move(text)}] = std::move(samples);
}

const std::vector<float>* RecordedPrompts::of(const Utterance& utterance) const {
    const auto found = prompts_.find({utterance.language, utterance.text});
    return found == prompts_.end() ? nullptr : &found->second;
}

}  // namespace touchline
