#include "haptics/device/odrive/odrive_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace touchline {
namespace {

constexpr int decimals = 6;
constexpr double greatest_value = 1e6;

std::uint8_t checksum_of(std::string_view text) {
    std::uint8_t sum = 0;
    for (const char c : text) sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    return sum;
}

std::optional<double> number_at_front(std::string_view& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

// Takes the checksum off; nothing if it is missing or wrong.
std::optional<std::string_view> checked(std::string_view line) {
    const std::size_t star = line.rfind('*');
    if (star == std::string_view::npos) return std::nullopt;
    const std::string_view told = line.substr(star + 1);
    unsigned sum = 0;
    const auto [end, error] = std::from_chars(told.data(), told.data() + told.size(), sum);
    const bool is_whole = error == std::errc{} && end == told.data() + told.size();
    const std::string_view text = line.substr(0, star);
    if (!is_whole || sum != checksum_of(text)) return std::nullopt;
    return text;
}

}  // namespace

void OdriveText::torque(int axis, double torque_Nm) {
    begin();
    add("c ");
    add_number(axis);
    add(" ");
    add_number(std::isfinite(torque_Nm) ? torque_Nm : 0.0);
    end();
}

void OdriveText::feed(int axis) {
    begin();
    add("u ");
    add_number(axis);
    end();
}

void OdriveText::ask_place(int axis) {
    begin();
    add("f ");
    add_number(axis);
    end();
}

void OdriveText::ask(int axis, std::string_view property) {
    begin();
    add("r axis");
    add_number(axis);
    add(".");
    add(property);
    end();
}

void OdriveText::set(int axis, std::string_view property, double value) {
    begin();
    add("w axis");
    add_number(axis);
    add(".");
    add(property);
    add(" ");
    add_number(value);
    end();
}

void OdriveText::set_mark(std::uint32_t mark) {
    begin();
    add("w test_property ");
    add_number(mark);
    end();
}

void OdriveText::put_line(std::string_view line) {
    begin();
    add(line);
    end();
}

void OdriveText::add(std::string_view text) {
    const std::size_t taken = std::min(text.size(), line_.size() - line_size_);
    std::copy_n(text.begin(), taken, line_.begin() + static_cast<std::ptrdiff_t>(line_size_));
    line_size_ += taken;
}

// Whole numbers without decimals, as the board reads whole properties.
void OdriveText::add_number(double value) {
    const double safe = std::clamp(value, -greatest_value, greatest_value);
    std::array<char, 24> digits{};
    const auto [end, error] =
        safe == std::trunc(safe)
            ? std::to_chars(digits.begin(), digits.end(), static_cast<long>(safe))
            : std::to_chars(digits.begin(), digits.end(), safe, std::chars_format::fixed, decimals);
    if (error == std::errc{}) add({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

void OdriveText::end() {
    const std::uint8_t sum = checksum_of({line_.data(), line_size_});
    add("*");
    add_number(sum);
    add("\n");
    put_raw({line_.data(), line_size_});
}

void OdriveText::put_raw(std::string_view text) {
    if (size_ + text.size() > text_.size()) return;
    for (const char c : text) text_[size_++] = static_cast<std::uint8_t>(c);
}

OdriveAnswer odrive_answer(std::string_view line) {
    auto text = checked(line);
    if (!text || text->empty()) return {};
    const auto first = number_at_front(*text);
    if (!first) return {OdriveAnswer::Kind::refused};
    if (text->empty()) return {OdriveAnswer::Kind::number, *first};
    if (text->front() != ' ') return {};
    text->remove_prefix(1);
    const auto second = number_at_front(*text);
    if (!second || !text->empty()) return {};
    return {OdriveAnswer::Kind::place, *first};
}

}  // namespace touchline
