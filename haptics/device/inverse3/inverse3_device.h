// An Inverse3 held to a horizontal plane: the driver over any Inverse3Link. It hands over a force
// at the end of a tick and takes the place at the next. The service needs a new command all the
// time; without news of the handle, zero is told.
#pragma once

#include "haptics/device/force_device.h"
#include "haptics/device/inverse3/inverse3_link.h"
#include "haptics/device/plane_spring.h"
#include "haptics/pantograph/profile.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace touchline {

/// Of the plane above the foot of the arm. The profile "inverse3" tells where the drawing area lies
/// in it.
inline constexpr double inverse3_plane_m = 0.15;

/// From good to bad. waiting: no place is new enough, or no command was answered yet. hindered: it
/// is not fit for force (Hindrance). lost: the service closed the conversation, for good.
enum class ArmState : std::uint8_t { ready, waiting, hindered, lost };

/// What the driver saw, for the operator and the log.
struct ArmReport {
    ArmState state = ArmState::waiting;
    Hindrance hindrance = Hindrance::none;
    bool was_force_not_finite = false;
    std::uint64_t places = 0;
    std::uint64_t no_news = 0;  // frames that told nothing
};

/// Threads: as ForceDevice. Only end_in_zero(), stop() and the destructor wait.
class Inverse3Device final : public ForceDevice {
  public:
    /// `profile` is a Cartesian one.
    Inverse3Device(std::unique_ptr<Inverse3Link> link, const DeviceProfile& profile)
        : link_(std::move(link)), profile_(profile) {}

    /// Calls stop().
    ~Inverse3Device() override;

    /// Returns where the handle is, seen from above, at most 4 ms after the tick in which it came;
    /// until the next one comes, the same, which is not new then.
    /// Returns nothing while the state is not ready.
    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override;

    /// Tells the force, with what holds the handle to the plane, together within the profile's
    /// limit. For zero, returns true once the service answered a zero, told since the last force,
    /// and said that it applies none. For others, returns false while the state is not ready; then
    /// zero is told.
    [[nodiscard]] bool write(const DeviceCommand& command) override;

    /// Tells zero until write({}) returns true, for at most 0.1 s. For callers that have no next
    /// tick.
    bool end_in_zero();

    /// As end_in_zero(), then ends the conversation. Nothing is read or written afterwards.
    bool stop();

    [[nodiscard]] const ArmReport& report() const { return report_; }

    /// How far the handle is above the plane, when its place was last read.
    [[nodiscard]] double off_plane_m() const { return off_m_; }

  private:
    [[nodiscard]] ArmState judge(const ArmNews& news) const;
    void follow_height(double off_m, double dt_s);
    [[nodiscard]] bool holds_zero();
    void tell(Space force_N);

    std::unique_ptr<Inverse3Link> link_;
    DeviceProfile profile_;
    ArmReport report_;
    ArmNews news_;
    std::uint64_t handed_over_ = 0;  // the number of the place told last
    std::optional<double> last_s_;   // on the caller's clock
    double age_s_ = 0.0;             // since a place came
    double off_m_ = 0.0;             // above the plane
    double off_m_per_s_ = 0.0;       // upwards
    bool is_height_known_ = false;
    WantedArmForce told_;
    std::uint64_t first_zero_ = 1;  // since the last force
};

}  // namespace touchline
