// One conversation with the service: it answers every frame of ours with one of its own, so each
// side waits for the other. Frames go in and out as texts; who carries them is another's business.
#pragma once

#include "config/types/result.h"
#include "haptics/device/inverse3/inverse3_frames.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace touchline {

/// Why a device that is there gives no place and takes no force, the first that holds.
enum class Hindrance : std::uint8_t { none, other_axes, no_power, not_calibrated, not_ready };

/// In one line: what is wrong, and what to do. Empty for none.
[[nodiscard]] std::string_view words_of(Hindrance hindrance);

/// A force that is wanted, of a number that goes up with each.
struct WantedArmForce {
    Space force_N;
    std::uint64_t number = 0;  // 0: none was wanted yet
};

/// What is known of the device now. Trivially copied between threads.
struct ArmNews {
    std::uint64_t places = 0;  // told so far, of which the newest is:
    Space place_m;
    std::optional<Space> velocity_m_per_s;
    double way_s = 0.0;  // from the command to its answer with this place, somewhere between
    Hindrance hindrance = Hindrance::none;
    std::uint64_t answered = 0;  // the number of the newest command that was answered
    bool applies_none = false;   // the service says that it applies no force, or does not say
    bool is_gone = false;        // the service closed the conversation, for good
    std::uint64_t no_news = 0;   // frames unreadable, not asked for or silent about the device
};

/// Silence of this length is the loss of the other: of the service, which is told zero once more,
/// and of the one who wants forces, for whom zero is told. With a tick before and a frame's way
/// after it the force ends within 20 ms.
inline constexpr double longest_arm_silence_s = 0.018;

/// Threads: a plain value. hear() allocates. `now_s` never goes back.
class Inverse3Session {
  public:
    /// For the device of this name; empty: the only one there is.
    explicit Inverse3Session(std::string_view name);

    /// Takes a frame of the service. Its place counts only if it answers the newest command.
    void hear(std::string_view text, double now_s);

    /// Returns the frame to send now, which then counts as sent. A force goes once, when the answer
    /// to the one before is in. Until a device is chosen, the service is asked for the list, first
    /// after 0.3 s, for it tells it unasked; then there is quiet for 50 ms, so that no answer to an
    /// earlier question is taken for another.
    [[nodiscard]] std::optional<CommandText> due(const WantedArmForce& newest, double now_s);

    /// True once a device is chosen, which stays the same.
    [[nodiscard]] bool has_arm() const { return arm_.has_value(); }

    /// The chosen device's; empty while there is none.
    [[nodiscard]] std::string_view name() const { return arm_ ? arm_->text() : std::string_view(); }

    /// Notes that the service closed the conversation.
    void lose() { news_.is_gone = true; }

    /// Nothing if a device is chosen and fit for force, else one line in words.
    [[nodiscard]] Result<void> readiness() const;

    [[nodiscard]] const ArmNews& news() const { return news_; }

  private:
    void begin(double now_s);
    [[nodiscard]] CommandText ask(double now_s);
    [[nodiscard]] CommandText command(const WantedArmForce& wanted, double now_s);
    void choose(const ServiceFrame& frame, double now_s);
    void follow(const ArmInFrame& arm, double now_s);

    std::string wanted_;
    std::optional<ArmName> arm_;
    bool has_session_ = false;
    bool has_other_axes_ = false;  // by the list of devices, which alone tells
    ArmStatus status_;             // what was said last of each
    std::string refusal_;          // why no device is chosen
    ArmNews news_;
    int owed_ = 0;                // answers
    bool has_begun_ = false;      // the time is known
    double quiet_until_s_ = 0.0;  // nothing is sent before
    double sent_s_ = 0.0;         // the newest frame
    double wanted_s_ = 0.0;       // since when the newest force is wanted
    WantedArmForce told_;
};

}  // namespace touchline
