// The state of the kiosk as its operator hears it: what does not work comes first.
// Threads: values and pure functions.
#pragma once

#include "app/printing/print_end.h"
#include "audio-cues/words/language.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace touchline {

enum class CameraHealth : std::uint8_t { none, ready, unplugged, stopped };  // none: not wanted

/// What is known of the networks that look at photographs.
struct NetworkHealth {
    int missing = 0;             // not installed
    bool lacks_shipped = false;  // one of these comes with Touchline
};

struct KioskHealth {
    std::string handle;          // what it is, in words of the language; empty: not known
    std::string handle_trouble;  // sentences of the language; empty: it works
    bool has_motors = false;
    std::optional<double> homed_ago_s;  // nothing: not since the kiosk was started
    bool has_sound = true;
    bool is_on_headphones = false;
    CameraHealth camera = CameraHealth::none;
    bool notices_sticks = true;
    bool has_stick = false;
    NetworkHealth networks;
    std::optional<PrintEnd> printer;  // of its last check; nothing: no printer, or not known yet
    bool can_keep = true;             // settings and counts reach the disk
    std::uint64_t faults_today = 0;
    double started_ago_s = 0.0;
    std::string version;
};

/// How much a line asks of the operator.
enum class Urgency : std::uint8_t { trouble, remark, none };

struct HealthLine {
    Urgency urgency = Urgency::none;
    std::string name;   // of a part, or whole sentences that name it and what to do
    std::string value;  // empty after sentences
};

/// The most urgent first; else in the order of KioskHealth.
[[nodiscard]] std::vector<HealthLine> health_lines(const KioskHealth& health,
                                                   const Language& language);

}  // namespace touchline
