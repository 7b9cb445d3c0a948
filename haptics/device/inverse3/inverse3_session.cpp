#include "haptics/device/inverse3/inverse3_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace touchline {
namespace {

constexpr double least_force_N = 1e-3;  // less than this counts as none
constexpr double unasked_s = 0.3;       // for the list of devices that comes by itself
constexpr double between_questions_s = 0.2;
constexpr double settling_s = 0.05;

bool is_none(Space force_N) {
    const auto is_small = [](double v) { return std::abs(v) < least_force_N; };
    return is_small(force_N.x) && is_small(force_N.y) && is_small(force_N.z);
}

void take(std::optional<bool>& known, const std::optional<bool>& said) {
    if (said) known = said;
}

/// What is not said does not hinder.
Hindrance hindrance_of(const ArmStatus& status, bool has_other_axes) {
    if (has_other_axes) return Hindrance::other_axes;
    if (!status.has_power.value_or(true)) return Hindrance::no_power;
    if (!status.is_calibrated.value_or(true)) return Hindrance::not_calibrated;
    if (!status.is_ready.value_or(true)) return Hindrance::not_ready;
    return Hindrance::none;
}

std::string names_of(const ServiceFrame& frame) {
    std::string names;
    for (std::size_t i = 0; i < frame.arm_count; ++i)
        names += fmt::format("{}{}", i == 0 ? "" : ", ", frame.arms[i].name.text());
    return names.empty() ? "none" : names;
}

}  // namespace

std::string_view words_of(Hindrance hindrance) {
    switch (hindrance) {
        case Hindrance::none:
            break;
        case Hindrance::other_axes:
            return "the Inverse3's axes were moved or turned in its service: set its preset, mount "
                   "and workspace there back to their defaults";
        case Hindrance::no_power:
            return "the Inverse3's motors have no power: plug in its power supply";
        case Hindrance::not_calibrated:
            return "the Inverse3 is not calibrated: put its handle into the holder on its base and "
                   "wait";
        case Hindrance::not_ready:
            return "the Inverse3 says that it is not ready: wait, and look at it in its maker's "
                   "program if it stays so";
    }
    return {};
}

Inverse3Session::Inverse3Session(std::string_view name)
    : wanted_(name), refusal_("the Inverse3's service has not named its devices yet") {}

void Inverse3Session::begin(double now_s) {
    if (std::exchange(has_begun_, true)) return;
    wanted_s_ = now_s;
    quiet_until_s_ = now_s + unasked_s;
}

void Inverse3Session::hear(std::string_view text, double now_s) {
    begin(now_s);
    const bool is_asked_for = owed_ > 0 || !arm_;
    owed_ = std::max(owed_ - 1, 0);
    const auto frame = is_asked_for ? read_frame(text) : std::nullopt;
    if (frame && !arm_) choose(*frame, now_s);
    const ArmInFrame* const arm = frame && arm_ ? frame->find(*arm_) : nullptr;
    if (arm != nullptr) {
        follow(*arm, now_s);
    } else {
        ++news_.no_news;
    }
}

std::optional<CommandText> Inverse3Session::due(const WantedArmForce& newest, double now_s) {
    begin(now_s);
    const bool is_new = newest.number != told_.number;
    if (is_new) wanted_s_ = now_s;
    if (now_s < quiet_until_s_) return std::nullopt;
    if (!arm_) return ask(now_s);
    const bool is_late = now_s - sent_s_ >= longest_arm_silence_s;
    if (owed_ == 0 && is_new) return command(newest, now_s);
    // Nobody renews the force, or the service does not answer: zero, in any case.
    const bool is_forgotten = owed_ == 0 && now_s - wanted_s_ >= longest_arm_silence_s;
    const bool is_unanswered = owed_ > 0 && told_.force_N != Space{};
    if (is_late && (is_forgotten || is_unanswered)) return command({{}, told_.number}, now_s);
    return std::nullopt;
}

CommandText Inverse3Session::ask(double now_s) {
    quiet_until_s_ = now_s + between_questions_s;
    return inventory_request();
}

CommandText Inverse3Session::command(const WantedArmForce& wanted, double now_s) {
    ++owed_;
    sent_s_ = now_s;
    told_ = wanted;
    if (!is_finite(told_.force_N)) told_.force_N = {};
    return force_command(*arm_, told_.force_N, has_session_);
}

void Inverse3Session::choose(const ServiceFrame& frame, double now_s) {
    const auto is_wanted = [&](const ArmInFrame& arm) {
        return wanted_.empty() ? !arm.is_other_kind : arm.name.text() == wanted_;
    };
    const auto* const end = frame.arms.begin() + frame.arm_count;
    const auto* const found = std::find_if(frame.arms.begin(), end, is_wanted);
    if (found == end) {
        refusal_ = wanted_.empty()
                       ? "no Inverse3 is plugged in, by what its service says: check the cable"
                       : fmt::format(
                             "the Inverse3 {} is not plugged in, by what its service says "
                             "(there: {}): check the cable and the setting device.port",
                             wanted_, names_of(frame));
        return;
    }
    if (found->is_other_kind) {
        refusal_ = fmt::format("the device {} is no Inverse3: its reach is another", wanted_);
        return;
    }
    if (std::count_if(frame.arms.begin(), end, is_wanted) > 1) {
        refusal_ = fmt::format(
            "more than one Inverse3 is plugged in ({}): write the name of the "
            "right one into the setting device.port",
            names_of(frame));
        return;
    }
    arm_ = found->name;
    has_session_ = frame.has_session;
    has_other_axes_ = found->has_other_axes;
    quiet_until_s_ = now_s + settling_s;
}

void Inverse3Session::follow(const ArmInFrame& arm, double now_s) {
    take(status_.has_power, arm.status.has_power);
    take(status_.is_calibrated, arm.status.is_calibrated);
    take(status_.is_ready, arm.status.is_ready);
    news_.hindrance = hindrance_of(status_, has_other_axes_ || arm.has_other_axes);
    if (owed_ > 0) return;
    news_.answered = told_.number;
    news_.applies_none = is_none(arm.applied_N.value_or(Space{}));
    if (!arm.place_m) {
        ++news_.no_news;
        return;
    }
    ++news_.places;
    news_.place_m = *arm.place_m;
    news_.velocity_m_per_s = arm.velocity_m_per_s;
    news_.way_s = now_s - sent_s_;
}

Result<void> Inverse3Session::readiness() const {
    if (!arm_) return failure(refusal_);
    if (news_.hindrance != Hindrance::none) return failure(std::string(words_of(news_.hindrance)));
    return {};
}

}  // namespace touchline
