// Detects headphones by a sound card's control for its socket ("Headphone Jack").
// Threads: one.
#pragma once

#include "audio-cues/output/headphones.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// A switch of a card that reports rather than sets.
struct CardSwitch {
    std::string name;
    bool is_on = false;
};

/// True for "Headphone Jack", "Front Headphone Jack", "Headphone Mic Jack", "Headset Jack"; not for
/// the phantom jacks of cards that cannot tell, nor for a microphone's.
[[nodiscard]] bool is_headphone_jack(std::string_view control);

/// Returns whether one of the headphone jacks is on; nothing if there are none.
[[nodiscard]] std::optional<bool> are_headphones_in(const std::vector<CardSwitch>& switches);

/// Returns the switches of every card's jacks, as ALSA reports them; a card that cannot be asked
/// has none. Takes a millisecond.
[[nodiscard]] std::vector<CardSwitch> card_switches();

/// Asks the cards every `period_s`, because they may come and go with a USB headset.
class JackControl final : public HeadphonePresence {
  public:
    using Ask = std::function<std::vector<CardSwitch>()>;

    explicit JackControl(Ask ask = card_switches) : ask_(std::move(ask)) {}

    [[nodiscard]] std::optional<bool> are_in(double now_s) override;

    static constexpr double period_s = 0.25;

  private:
    Ask ask_;
    double asked_s_ = -period_s;
    std::optional<bool> are_in_;
};

}  // namespace touchline
