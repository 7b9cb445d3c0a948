#include "audio-cues/output/outputs.h"

#include "audio-cues/synth/gain.h"

#include <algorithm>
#include <cmath>

#include <alsa/asoundlib.h>

namespace touchline {
namespace {

struct CloseControl {
    void operator()(snd_ctl_t* card) const { snd_ctl_close(card); }
};

using Card = std::unique_ptr<snd_ctl_t, CloseControl>;

Card open_card(int number) {
    snd_ctl_t* card = nullptr;
    const std::string name = "hw:" + std::to_string(number);
    return Card(snd_ctl_open(&card, name.c_str(), SND_CTL_NONBLOCK) == 0 ? card : nullptr);
}

/// All names of a card at once.
class ElementList : private Pinned {
  public:
    explicit ElementList(snd_ctl_t* card) {
        snd_ctl_elem_list_malloc(&list_);
        is_whole_ = snd_ctl_elem_list(card, list_) == 0 &&
                    snd_ctl_elem_list_alloc_space(list_, snd_ctl_elem_list_get_count(list_)) == 0 &&
                    snd_ctl_elem_list(card, list_) == 0;
    }

    ~ElementList() {
        snd_ctl_elem_list_free_space(list_);
        snd_ctl_elem_list_free(list_);
    }

    [[nodiscard]] unsigned size() const {
        return is_whole_ ? snd_ctl_elem_list_get_used(list_) : 0;
    }

    [[nodiscard]] std::string name(unsigned i) const {
        return snd_ctl_elem_list_get_name(list_, i);
    }

    [[nodiscard]] unsigned number(unsigned i) const {
        return snd_ctl_elem_list_get_numid(list_, i);
    }

  private:
    snd_ctl_elem_list_t* list_ = nullptr;
    bool is_whole_ = false;
};

bool is_on(snd_ctl_t* card, unsigned number) {
    snd_ctl_elem_value_t* value = nullptr;
    if (snd_ctl_elem_value_malloc(&value) != 0) return false;
    snd_ctl_elem_value_set_numid(value, number);
    const bool is_on =
        snd_ctl_elem_read(card, value) == 0 && snd_ctl_elem_value_get_boolean(value, 0) != 0;
    snd_ctl_elem_value_free(value);
    return is_on;
}

void add_switches(snd_ctl_t* card, std::vector<CardSwitch>& switches) {
    const ElementList elements(card);
    for (unsigned i = 0; i < elements.size(); ++i) {
        if (!is_headphone_jack(elements.name(i))) continue;
        switches.push_back({elements.name(i), is_on(card, elements.number(i))});
    }
}

bool holds(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

}  // namespace

std::optional<bool> are_headphones_in(const HeadphoneReports& reports) {
    const auto known = std::find_if(reports.begin(), reports.end(),
                                    [](const auto& report) { return report.has_value(); });
    return known == reports.end() ? std::nullopt : *known;
}

OutputKind output_kind(std::optional<bool> are_in, const SoundSettings& settings) {
    if (!are_in) return settings.assumed;
    return *are_in ? OutputKind::headset : OutputKind::speaker;
}

const OutputProfile& profile_of(OutputKind kind, const SoundSettings& settings) {
    return kind == OutputKind::headset ? settings.headset : settings.speaker;
}

bool is_headphone_jack(std::string_view control) {
    const bool is_for_ears = holds(control, "Headphone") || holds(control, "Headset");
    const bool is_microphone_alone = control.starts_with("Headset Mic");
    return is_for_ears && !is_microphone_alone && control.ends_with(" Jack") &&
           !holds(control, "Phantom");
}

std::optional<bool> are_headphones_in(const std::vector<CardSwitch>& switches) {
    std::optional<bool> are_in;
    for (const CardSwitch& one : switches)
        if (is_headphone_jack(one.name)) are_in = are_in.value_or(false) || one.is_on;
    return are_in;
}

std::vector<CardSwitch> card_switches() {
    std::vector<CardSwitch> switches;
    int number = -1;
    while (snd_card_next(&number) == 0 && number >= 0)
        if (const Card card = open_card(number)) add_switches(card.get(), switches);
    return switches;
}

std::optional<bool> JackControl::are_in(double now_s) {
    if (now_s - asked_s_ < period_s) return are_in_;
    asked_s_ = now_s;
    are_in_ = are_headphones_in(ask_());
    return are_in_;
}

std::size_t volume_steps(const OutputProfile& profile) {
    const double steps =
        std::floor((profile.loudest_dB - profile.quietest_dB) / profile.step_dB + 0.01);
    return steps >= 0.0 && steps < 1000.0 ? static_cast<std::size_t>(steps) + 1 : 1;
}

std::size_t default_volume(const OutputProfile& profile) {
    const double step = std::round((profile.default_dB - profile.quietest_dB) / profile.step_dB);
    const auto last = static_cast<double>(volume_steps(profile) - 1);
    return step >= 0.0 ? static_cast<std::size_t>(std::min(step, last)) : 0;
}

double level_dB_of(const OutputProfile& profile, std::size_t step) {
    const std::size_t there = std::min(step, volume_steps(profile) - 1);
    return profile.quietest_dB + static_cast<double>(there) * profile.step_dB;
}

VolumeChange change_volume(const OutputProfile& profile, std::size_t step, int change) {
    const std::size_t last = volume_steps(profile) - 1;
    const std::size_t now = std::min(step, last);
    if (change > 0) return now == last ? VolumeChange{now, true} : VolumeChange{now + 1, false};
    return now == 0 ? VolumeChange{now, true} : VolumeChange{now - 1, false};
}

SetOutput output_of(const OutputProfile& profile, std::size_t step) {
    const double gain_dB =
        level_dB_of(profile, step) - profile.full_scale_dB + speech_below_full_dB;
    // The middle gives each ear the square root of a half, so the cap applies to what arrives
    // there.
    const double cap = gain_of_dB(profile.cap_dB - profile.full_scale_dB - 3.01);
    return {gain_of_dB(gain_dB), std::min(cap, 1.0), profile.is_mono};
}

}  // namespace touchline
