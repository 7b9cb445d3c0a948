// CAN-FD frames over a socket of the system. The interface must be up: its bit rates are root's.
#pragma once

#include "config/types/result.h"
#include "haptics/device/moteus/frame_link.h"

#include <memory>
#include <optional>
#include <string>

namespace touchline {

/// Threads: as FrameLink.
class CanSocket final : public FrameLink {
  public:
    /// Takes over an open socket that carries one canfd_frame a packet and does not block.
    explicit CanSocket(int descriptor) : descriptor_(descriptor) {}

    ~CanSocket() override;

    [[nodiscard]] bool send(const CanFrame& frame) override;
    [[nodiscard]] std::optional<CanFrame> receive() override;

    [[nodiscard]] bool is_gone() const override { return is_gone_; }

    void rest(double span_s) override;

  private:
    int descriptor_;
    bool is_gone_ = false;
};

/// Opens the interface, e.g. can0. Fails in one line if there is none of that name, it is down, or
/// it carries no CAN-FD frames.
[[nodiscard]] Result<std::unique_ptr<FrameLink>> open_can_socket(const std::string& interface);

}  // namespace touchline
