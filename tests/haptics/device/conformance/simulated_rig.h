// What the devices in software have in common as rigs: time is what read() is told, and the line is
// a switch in front of them. Threads: one.
#pragma once

#include "haptics/device/simulated/simulated_pantograph.h"
#include "tests/haptics/device/conformance/device_rig.h"

#include <memory>
#include <optional>

namespace touchline {

/// A line in front of a device that can be cut: then nothing is told and nothing taken, and the
/// device holds zero.
class CutLine final : public ForceDevice {
  public:
    explicit CutLine(ForceDevice& behind) : behind_(behind) {}

    [[nodiscard]] std::optional<DeviceReading> read(double now_s) override {
        auto told = behind_.read(now_s);
        if (is_cut) return std::nullopt;
        return told;
    }

    [[nodiscard]] bool write(const DeviceCommand& command) override {
        const bool is_taken = behind_.write(is_cut ? DeviceCommand{} : command);
        return is_taken && !is_cut;
    }

    bool is_cut = false;

  private:
    ForceDevice& behind_;
};

/// A device in software as a rig, with a hand that stands where it is told to. A derived rig tells
/// what acts.
template <class Device, class Options>
class SimulatedRig : public DeviceRig {
  public:
    explicit SimulatedRig(const DeviceProfile& profile)
        : profile_(profile), device_(profile, Options{}, hand_) {}

    ForceDevice& device() override { return line_; }

    [[nodiscard]] const DeviceProfile& profile() const override { return profile_; }

    bool open() override { return true; }

    [[nodiscard]] double now_s() const override { return now_s_; }

    void pass(double span_s) override { now_s_ += span_s; }

    void move_hand(Position p_D) override { hand_->move_to(picture_from_device(profile_, p_D)); }

    void cut() override { line_.is_cut = true; }

    void fall_silent() override { cut(); }

    void join() override { line_.is_cut = false; }

    /// There are no bits to spoil.
    void garble_next(unsigned /*seed*/) override {}

    /// Nothing is on its way.
    void slow_answers(double /*late_s*/, int /*ticks*/) override {}

    [[nodiscard]] Position true_p_D() const override {
        return device_from_picture(profile_, device_.tip().position);
    }

  protected:
    [[nodiscard]] const Device& simulated() const { return device_; }

  private:
    DeviceProfile profile_;
    std::shared_ptr<MouseHand> hand_ = std::make_shared<MouseHand>(Position{});
    Device device_;
    CutLine line_{device_};
    double now_s_ = 0.0;
};

}  // namespace touchline
