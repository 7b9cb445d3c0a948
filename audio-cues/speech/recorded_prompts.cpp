#include "audio-cues/speech/recorded_prompts.h"

#include "audio-cues/speech/wav.h"

#include <filesystem>
#include <fstream>

namespace touchline {

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
