#include "tests/machines/sim/kiosk/heard.h"

namespace touchline {

std::string Heard::text_since(std::size_t first) const {
    std::string text;
    for (std::size_t i = first; i < things.size(); ++i)
        if (!things[i].text.empty()) text += things[i].text + '\n';
    return text;
}

std::string Heard::last_text() const {
    for (auto at = things.rbegin(); at != things.rend(); ++at)
        if (!at->text.empty()) return at->text;
    return {};
}

bool Heard::was_said(const std::string& part, std::size_t first) const {
    return text_since(first).find(part) != std::string::npos;
}

void HeardSound::say(const Utterance& utterance) {
    heard_->things.push_back({heard_->now_s, utterance.language, utterance.text, {}});
}

void HeardSound::give(ScreenEvent event) {
    heard_->things.push_back({heard_->now_s, "", "", event});
}

void HeardSound::play_side(bool is_left) {
    heard_->things.push_back({heard_->now_s, "", is_left ? "left" : "right", {}});
}

void HeardSound::forget() {
    ++heard_->forgotten;
}

}  // namespace touchline
