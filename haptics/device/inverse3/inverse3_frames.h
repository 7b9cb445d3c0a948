// What the maker's service and its clients say to each other: one JSON text a frame. Text in,
// values out, and the other way round. Nothing in a text is trusted: sizes are bounded and numbers
// checked. Threads: pure functions of values.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace touchline {

/// In space, as the service counts: x to the right, y away from the person, z up. Metres, metres a
/// second or newtons, by the name.
struct Space {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    friend constexpr bool operator==(Space a, Space b) noexcept = default;
};

[[nodiscard]] bool is_finite(Space v);

/// A device's name on the service, which is printed on it: letters, digits, '-' and '_' only.
class ArmName {
  public:
    static constexpr std::size_t longest = 32;

    ArmName() = default;

    /// Returns nothing if `text` is empty, too long or has another character.
    [[nodiscard]] static std::optional<ArmName> of(std::string_view text);

    [[nodiscard]] std::string_view text() const { return {letters_.data(), size_}; }

    friend bool operator==(const ArmName& a, const ArmName& b) { return a.text() == b.text(); }

  private:
    std::array<char, longest> letters_{};
    std::size_t size_ = 0;
};

/// What a frame says of a device's condition. Nothing: it does not say.
struct ArmStatus {
    std::optional<bool> has_power;
    std::optional<bool> is_calibrated;
    std::optional<bool> is_ready;
};

/// One device in a frame.
struct ArmInFrame {
    ArmName name;
    bool is_other_kind = false;    // neither an Inverse3 nor an Inverse3x
    bool has_other_axes = false;   // the service was told to turn, move or scale them
    std::optional<Space> place_m;  // of the handle
    std::optional<Space> velocity_m_per_s;
    std::optional<Space> applied_N;  // the force that the service says it applies
    ArmStatus status;
};

struct ServiceFrame {
    static constexpr std::size_t most_arms = 8;

    std::array<ArmInFrame, most_arms> arms;
    std::size_t arm_count = 0;
    bool has_session = false;  // it numbers sessions, as services from 3.5 on do

    /// Null if there is no such device.
    [[nodiscard]] const ArmInFrame* find(const ArmName& name) const;
};

inline constexpr std::size_t longest_frame_bytes = 65536;

/// Reads one frame of the service; what is not of interest is passed over. Returns nothing if it is
/// too long, too deep, no JSON, has more than most_arms devices, two of one name or one without,
/// half a vector, a number that is not finite or that no hand can reach: more than 1 m, 20 m/s or
/// 100 N. O(n), allocates.
[[nodiscard]] std::optional<ServiceFrame> read_frame(std::string_view text);

/// One frame of ours. No allocation.
class CommandText {
  public:
    [[nodiscard]] std::string_view text() const { return {letters_.data(), size_}; }

  private:
    friend CommandText inventory_request();
    friend CommandText force_command(const ArmName& name, Space force_N, bool has_session);

    std::array<char, 192> letters_{};
    std::size_t size_ = 0;
};

/// Asks for the list of devices.
[[nodiscard]] CommandText inventory_request();

/// Asks for a force on the hand until the next command, to 0.1 mN; zero if an axis is not finite or
/// above 100 N, for it is the caller who limits it. A service that numbers sessions has another
/// word for the vector.
[[nodiscard]] CommandText force_command(const ArmName& name, Space force_N, bool has_session);

}  // namespace touchline
