// Records that cross processes, or go into files that only this program reads. Each record names
// its fields once, in a template that takes the operation on them:
//
//     template <class Fields, class Header>
//     void fields(Fields& f, Header& header) {
//         f.number(header.width_m, 0.0, 1.0);
//         f.finite(header.place_m);
//         f.choice(header.kind, Kind::last);
//         f.flag(header.is_closed);
//     }
//
// ByteWriter and ByteReader convert them to bytes and back: little-endian, one field after the
// other. FieldCheck checks whether each is in its range, FieldEnd whether none was forgotten.
// Threads: plain values.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace touchline {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");

template <class T>
concept Number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

template <class T>
concept Choice = std::is_enum_v<T>;

class ByteWriter {
  public:
    template <Number T>
    void number(const T& value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof(T));
        std::memcpy(&bytes_[at], &value, sizeof(T));
    }

    template <Number T>
    void number(const T& value, std::type_identity_t<T> /*least*/,
                std::type_identity_t<T> /*most*/) {
        number(value);
    }

    template <Number T>
    void finite(const T& value) {
        number(value);
    }

    template <Choice T>
    void choice(const T& value, T /*last*/) {
        number(static_cast<std::underlying_type_t<T>>(value));
    }

    void flag(const bool& value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }

    /// Writes the length as a Size, then the text; cuts off what is longer than a Size can count.
    template <Number Size>
    void text(std::string_view value) {
        value = value.substr(0, std::numeric_limits<Size>::max());
        number(static_cast<Size>(value.size()));
        raw(value);
    }

    /// Writes how many records follow, for ByteReader::count().
    void count(std::size_t how_many) { number(static_cast<std::uint32_t>(how_many)); }

    void raw(std::span<const std::byte> bytes) {
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    void raw(std::string_view text) { raw(std::as_bytes(std::span(text))); }

    void reserve(std::size_t bytes) { bytes_.reserve(bytes); }

    [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

/// Reads any bytes, and never past the end. After a failure it stays failed, and returns zeros and
/// empty texts.
class ByteReader {
  public:
    explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

    template <Number T>
    void number(T& value) {
        value = T{};
        const auto from = raw(sizeof(T));
        if (!from.empty()) std::memcpy(&value, from.data(), sizeof(T));
    }

    /// Does not check the range.
    template <Number T>
    void number(T& value, std::type_identity_t<T> /*least*/, std::type_identity_t<T> /*most*/) {
        number(value);
    }

    template <Number T>
    void finite(T& value) {
        number(value);
    }

    template <Number T>
    [[nodiscard]] T number() {
        T value{};
        number(value);
        return value;
    }

    /// Fails for values after `last`.
    template <Choice T>
    void choice(T& value, T last) {
        using Told = std::underlying_type_t<T>;
        const auto told = number<Told>();
        is_good_ = is_good_ && told >= Told{} && told <= static_cast<Told>(last);
        value = is_good_ ? static_cast<T>(told) : T{};
    }

    /// Fails for anything but 0 and 1.
    void flag(bool& value) {
        const auto told = number<std::uint8_t>();
        is_good_ = is_good_ && told <= 1;
        value = told == 1;
    }

    template <Number Size>
    void text(std::string& value) {
        value = raw_text(number<Size>());
    }

    /// How many follow, as a std::uint32_t; fails, and is 0, where so many cannot, each of at least
    /// `least_bytes`.
    [[nodiscard]] std::uint32_t count(std::size_t least_bytes) {
        const auto told = number<std::uint32_t>();
        is_good_ = is_good_ && told <= left_.size() / least_bytes;
        return is_good_ ? told : 0;
    }

    [[nodiscard]] std::span<const std::byte> raw(std::size_t size) {
        is_good_ = is_good_ && size <= left_.size();
        if (!is_good_) return {};
        const auto front = left_.first(size);
        left_ = left_.subspan(size);
        return front;
    }

    [[nodiscard]] std::string raw_text(std::size_t size) {
        const auto from = raw(size);
        return {reinterpret_cast<const char*>(from.data()), from.size()};
    }

    [[nodiscard]] bool is_good() const { return is_good_; }

    [[nodiscard]] bool is_at_end() const { return is_good_ && left_.empty(); }

    [[nodiscard]] std::size_t left() const { return left_.size(); }

  private:
    std::span<const std::byte> left_;
    bool is_good_ = true;
};

/// Any bytes may lie where the record is. Every comparison is written so that NaN fails it.
class FieldCheck {
  public:
    template <Number T>
    void number(const T& /*any*/) {}

    template <Number T>
    void number(const T& value, std::type_identity_t<T> least, std::type_identity_t<T> most) {
        is_sound_ = is_sound_ && value >= least && value <= most;
    }

    template <Number T>
    void finite(const T& value) {
        is_sound_ = is_sound_ && std::isfinite(value);
    }

    template <Choice T>
    void choice(const T& value, T last) {
        is_sound_ = is_sound_ && value >= T{} && value <= last;
    }

    void flag(const bool& value) {
        std::uint8_t byte = 0;
        std::memcpy(&byte, &value, sizeof byte);
        is_sound_ = is_sound_ && byte <= 1;
    }

    template <Number Size>
    void text(const std::string& /*any*/) {}

    [[nodiscard]] bool is_sound() const { return is_sound_; }

  private:
    bool is_sound_ = true;
};

/// Reads a record and checks its ranges at once: `fields` takes the operation and the record, as
/// the template above. True if all bytes were there and every field is in its range.
template <class Record, class FieldsOf>
[[nodiscard]] bool read_checked(ByteReader& bytes, Record& record, const FieldsOf& fields) {
    FieldCheck check;
    fields(bytes, record);
    fields(check, record);
    return bytes.is_good() && check.is_sound();
}

/// Where a flat record of numbers, choices and flags ends in memory if its fields are all of its
/// members, in their order: at its size.
class FieldEnd {
  public:
    template <Number T>
    constexpr void number(const T& /*any*/) {
        add<T>();
    }

    template <Number T>
    constexpr void number(const T& /*any*/, std::type_identity_t<T> /*least*/,
                          std::type_identity_t<T> /*most*/) {
        add<T>();
    }

    template <Choice T>
    constexpr void choice(const T& /*any*/, T /*last*/) {
        add<T>();
    }

    constexpr void flag(const bool& /*any*/) { add<bool>(); }

    [[nodiscard]] constexpr std::size_t bytes() const { return rounded(end_, widest_); }

  private:
    static constexpr std::size_t rounded(std::size_t bytes, std::size_t to) {
        return (bytes + to - 1) / to * to;
    }

    template <class T>
    constexpr void add() {
        end_ = rounded(end_, alignof(T)) + sizeof(T);
        widest_ = std::max(widest_, alignof(T));
    }

    std::size_t end_ = 0;
    std::size_t widest_ = 1;
};

}  // namespace touchline
