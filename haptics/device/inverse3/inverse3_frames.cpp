#include "haptics/device/inverse3/inverse3_frames.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace touchline {
namespace {

constexpr std::size_t deepest = 12;
constexpr double furthest_m = 1.0;
constexpr double fastest_m_per_s = 20.0;
constexpr double strongest_N = 100.0;
constexpr double axes_tolerance = 1e-6;

/// The words on the way to what is of interest.
enum class Word : std::uint8_t {
    other,
    element,  // of a list
    inverse3,
    session_id,
    device_id,
    config,
    type,
    mount,
    basis,
    permutation,
    state,
    place,
    velocity,
    applied,
    transform,
    position,
    rotation,
    scale,
    x,
    y,
    z,
    w,
    status,
    power,
    calibrated,
    ready
};

constexpr std::array<std::pair<std::string_view, Word>, 24> words{{
    {"inverse3", Word::inverse3},
    {"session_id", Word::session_id},
    {"device_id", Word::device_id},
    {"config", Word::config},
    {"type", Word::type},
    {"mount", Word::mount},
    {"basis", Word::basis},
    {"permutation", Word::permutation},
    {"state", Word::state},
    {"cursor_position", Word::place},
    {"cursor_velocity", Word::velocity},
    {"current_cursor_force", Word::applied},
    {"transform", Word::transform},
    {"position", Word::position},
    {"rotation", Word::rotation},
    {"scale", Word::scale},
    {"x", Word::x},
    {"y", Word::y},
    {"z", Word::z},
    {"w", Word::w},
    {"status", Word::status},
    {"power_supply", Word::power},
    {"calibrated", Word::calibrated},
    {"ready", Word::ready},
}};

Word word_of(std::string_view text) {
    const auto* const found =
        std::ranges::find(words, text, &std::pair<std::string_view, Word>::first);
    return found == words.end() ? Word::other : found->second;
}

/// Three numbers as they come.
struct HalfSpace {
    std::optional<double> x, y, z;

    /// Returns false for another axis than these.
    bool put(Word axis, double value) {
        if (axis == Word::x) x = value;
        if (axis == Word::y) y = value;
        if (axis == Word::z) z = value;
        return axis == Word::x || axis == Word::y || axis == Word::z;
    }

    /// Sets `whole` and returns true if all or none have come, none beyond `most`.
    [[nodiscard]] bool finish(double most, std::optional<Space>& whole) const {
        if (!x && !y && !z) return true;
        if (!x || !y || !z) return false;
        const Space all{*x, *y, *z};
        const auto is_within = [&](double v) { return std::abs(v) <= most; };
        if (!is_within(all.x) || !is_within(all.y) || !is_within(all.z)) return false;
        whole = all;
        return true;
    }
};

/// Takes what the parser meets, and remembers the words that lead there. Each call returns false to
/// end the parsing.
class FrameReader {
  public:
    [[nodiscard]] const ServiceFrame& frame() const { return frame_; }

    bool start_object(std::size_t /*size*/) {
        if (!enter(Word::other)) return false;
        return !is_at_arm(3) || begin_arm();
    }

    bool end_object() {
        const bool is_whole = !is_at_arm(3) || end_arm();
        --depth_;
        return is_whole;
    }

    bool start_array(std::size_t /*size*/) { return enter(Word::element); }

    bool end_array() {
        --depth_;
        return true;
    }

    bool key(const std::string& text) {
        way_[depth_ - 1] = word_of(text);
        return true;
    }

    bool null() { return true; }

    bool boolean(bool value) {
        if (is_at({Word::status, Word::power})) arm().status.has_power = value;
        if (is_at({Word::status, Word::calibrated})) arm().status.is_calibrated = value;
        if (is_at({Word::status, Word::ready})) arm().status.is_ready = value;
        return true;
    }

    bool string(const std::string& text) {
        if (is_at({Word::device_id})) {
            const auto name = ArmName::of(text);
            if (!name || frame_.find(*name) != nullptr) return false;
            arm().name = *name;
        }
        if (is_at({Word::config, Word::type}))
            arm().is_other_kind = text != "inverse3" && text != "inverse3x";
        if (is_at({Word::config, Word::basis, Word::permutation}) && text != "XYZ")
            arm().has_other_axes = true;
        return true;
    }

    bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }

    bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }

    bool number_float(double value, const std::string& /*text*/) {
        return std::isfinite(value) && number(value);
    }

    template <class Binary>
    bool binary(const Binary& /*bytes*/) {
        return false;
    }

    template <class Failure>
    bool parse_error(std::size_t /*at*/, const std::string& /*token*/, const Failure& /*why*/) {
        return false;
    }

  private:
    bool enter(Word word) {
        if (depth_ == deepest) return false;
        way_[depth_++] = word;
        return true;
    }

    [[nodiscard]] bool is_at_arm(std::size_t depth) const {
        return depth_ == depth && way_[0] == Word::inverse3 && way_[1] == Word::element;
    }

    /// True if exactly these words lead from a device to here.
    [[nodiscard]] bool is_at(std::initializer_list<Word> from_arm) const {
        return is_at_arm(2 + from_arm.size()) &&
               std::equal(from_arm.begin(), from_arm.end(), way_.begin() + 2);
    }

    [[nodiscard]] ArmInFrame& arm() { return frame_.arms[frame_.arm_count]; }

    bool begin_arm() {
        if (frame_.arm_count == ServiceFrame::most_arms) return false;
        arm() = {};
        place_ = velocity_ = applied_ = {};
        return true;
    }

    bool end_arm() {
        const bool is_whole = !arm().name.text().empty() &&
                              place_.finish(furthest_m, arm().place_m) &&
                              velocity_.finish(fastest_m_per_s, arm().velocity_m_per_s) &&
                              applied_.finish(strongest_N, arm().applied_N);
        ++frame_.arm_count;
        return is_whole;
    }

    bool number(double value) {
        if (depth_ == 1 && way_[0] == Word::session_id) frame_.has_session = true;
        const Word axis = way_[depth_ == 0 ? 0 : depth_ - 1];
        if (is_at({Word::state, Word::place, axis})) place_.put(axis, value);
        if (is_at({Word::state, Word::velocity, axis})) velocity_.put(axis, value);
        if (is_at({Word::state, Word::applied, axis})) applied_.put(axis, value);
        judge_axes(axis, value);
        return true;
    }

    /// Axes are the device's own while nothing moves, turns or scales them.
    void judge_axes(Word axis, double value) {
        for (const Word group : {Word::config, Word::state}) {
            const Word what = group == Word::config ? Word::mount : Word::transform;
            const bool is_none = is_at({group, what, Word::position, axis}) ||
                                 (is_at({group, what, Word::rotation, axis}) && axis != Word::w);
            const bool is_one = is_at({group, what, Word::scale, axis}) ||
                                (is_at({group, what, Word::rotation, axis}) && axis == Word::w);
            const double own = is_one ? 1.0 : 0.0;
            if ((is_none || is_one) && !(std::abs(value - own) <= axes_tolerance))
                arm().has_other_axes = true;
        }
    }

    ServiceFrame frame_;
    HalfSpace place_, velocity_, applied_;
    std::array<Word, deepest> way_{};
    std::size_t depth_ = 0;
};

}  // namespace

bool is_finite(Space v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::optional<ArmName> ArmName::of(std::string_view text) {
    const auto is_plain = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
               c == '-' || c == '_';
    };
    if (text.empty() || text.size() > longest || !std::ranges::all_of(text, is_plain))
        return std::nullopt;
    ArmName name;
    std::ranges::copy(text, name.letters_.begin());
    name.size_ = text.size();
    return name;
}

const ArmInFrame* ServiceFrame::find(const ArmName& name) const {
    for (std::size_t i = 0; i < arm_count; ++i)
        if (arms[i].name == name) return &arms[i];
    return nullptr;
}

std::optional<ServiceFrame> read_frame(std::string_view text) {
    if (text.size() > longest_frame_bytes) return std::nullopt;
    FrameReader reader;
    if (!nlohmann::json::sax_parse(text, &reader)) return std::nullopt;
    return reader.frame();
}

CommandText inventory_request() {
    CommandText command;
    const auto written = fmt::format_to_n(command.letters_.data(), command.letters_.size(),
                                          R"({{"session":{{"force_render_full_state":{{}}}}}})");
    command.size_ = written.size;
    return command;
}

CommandText force_command(const ArmName& name, Space force_N, bool has_session) {
    const auto is_told = [](double v) { return std::abs(v) <= strongest_N; };  // NaN is not
    const bool is_safe = is_told(force_N.x) && is_told(force_N.y) && is_told(force_N.z);
    const Space safe_N = is_safe ? force_N : Space{};
    CommandText command;
    const auto written = fmt::format_to_n(
        command.letters_.data(), command.letters_.size(),
        R"({{"inverse3":[{{"device_id":"{}","commands":{{"set_cursor_force":{{"{}":{{"x":{:.4f},"y":{:.4f},"z":{:.4f}}}}}}}}}]}})",
        name.text(), has_session ? "vector" : "values", safe_N.x, safe_N.y, safe_N.z);
    command.size_ = written.size;
    return command;
}

}  // namespace touchline
