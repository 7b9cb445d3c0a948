#include "audio-cues/output/headphones.h"

#include <algorithm>

namespace touchline {

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

}  // namespace touchline
