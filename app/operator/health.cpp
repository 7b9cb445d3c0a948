#include "app/operator/health.h"

#include "app/visit/told_lines.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double minute_s = 60.0;
constexpr double hour_s = 60.0 * minute_s;
constexpr double day_s = 24.0 * hour_s;

/// Names the largest unit only. For spans up to a thousand years.
std::string ago_in_words(double span_s, const Language& language) {
    const auto counted = [&](const char* one, const char* many, double unit_s) {
        return language.counted("operator", one, many, static_cast<int>(span_s / unit_s));
    };
    if (!(span_s >= minute_s)) return language.text("operator", "just now");
    if (span_s < hour_s) return counted("{0} minute ago", "{0} minutes ago", minute_s);
    if (span_s < day_s) return counted("{0} hour ago", "{0} hours ago", hour_s);
    return counted("{0} day ago", "{0} days ago", day_s);
}

struct Lines {
    const KioskHealth& health;
    const Language& language;
    std::vector<HealthLine> lines;

    [[nodiscard]] std::string words(const char* english) const {
        return language.text("operator", english);
    }

    void add(Urgency urgency, const char* name, std::string value) {
        lines.push_back({urgency, words(name), std::move(value)});
    }

    /// An item's name has no stop at its end, because its place in the list follows.
    void add_sentences(std::string sentences) {
        if (sentences.ends_with('.')) sentences.pop_back();
        lines.push_back({Urgency::trouble, std::move(sentences), ""});
    }

    void add_trouble(const char* sentences) { add_sentences(words(sentences)); }

    void add_handle() {
        const Urgency urgency = health.has_motors ? Urgency::none : Urgency::remark;
        if (health.handle_trouble.empty())
            add(urgency, "Handle", health.handle.empty() ? words("working") : health.handle);
        else
            add_sentences(health.handle_trouble);
        if (!health.has_motors) return;
        if (health.homed_ago_s)
            add(Urgency::none, "Starting point found", ago_in_words(*health.homed_ago_s, language));
        else
            add(Urgency::remark, "Starting point found", words("not yet"));
    }

    void add_sound() {
        if (health.has_sound)
            add(Urgency::none, "Sound", words(health.is_on_headphones ? "headphones" : "speaker"));
        else
            add_trouble("There is no sound. Check the cable of the speaker.");
    }

    void add_camera() {
        switch (health.camera) {
            case CameraHealth::none:
                return;
            case CameraHealth::ready:
                return add(Urgency::none, "Camera", words("ready"));
            case CameraHealth::unplugged:
                return add(Urgency::remark, "Camera", words("not plugged in"));
            case CameraHealth::stopped:
                return add_trouble("The camera gives no picture. Plug it in again.");
        }
    }

    void add_sticks() {
        if (health.notices_sticks)
            add(Urgency::none, "USB stick",
                words(health.has_stick ? "plugged in" : "not plugged in"));
        else
            add_trouble("USB sticks are not noticed. Start the kiosk again.");
    }

    void add_networks() {
        const auto& [missing, lacks_shipped] = health.networks;
        if (lacks_shipped)
            add_trouble("Photos cannot be recognised. Install Touchline again.");
        else if (missing > 0)
            add(Urgency::remark, "Recognising photos",
                language.counted("operator", "{0} file is missing", "{0} files are missing",
                                 missing));
        else
            add(Urgency::none, "Recognising photos", words("complete"));
    }

    void add_printer() {
        if (!health.printer) return;
        if (*health.printer == PrintEnd::printed)
            add(Urgency::none, "Printer", words("ready"));
        else
            add_sentences(told_of_print(*health.printer, language, ToldTo::staff));
    }

    void add_rest() {
        if (!health.can_keep) add_trouble("Nothing can be saved. Make room on the disk.");
        add(health.faults_today > 0 ? Urgency::remark : Urgency::none, "Faults today",
            std::to_string(health.faults_today));
        add(Urgency::none, "Started", ago_in_words(health.started_ago_s, language));
        add(Urgency::none, "Version", health.version);
    }
};

}  // namespace

std::vector<HealthLine> health_lines(const KioskHealth& health, const Language& language) {
    Lines all{health, language, {}};
    all.add_handle();
    all.add_sound();
    all.add_camera();
    all.add_sticks();
    all.add_networks();
    all.add_printer();
    all.add_rest();
    std::ranges::stable_sort(all.lines, {}, &HealthLine::urgency);
    return std::move(all.lines);
}

}  // namespace touchline
