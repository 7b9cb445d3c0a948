// Sticks through udisks2 on the system's bus, which mounts and unmounts them. Waits for it if it is
// absent or restarts.
// Threads: one, which calls poll().
#pragma once

#include "app/documents/sticks/stick_port.h"
#include "app/documents/sticks/stick_rules.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace touchline {

class UdisksPort final : public StickPort {
  public:
    /// Does not look at the bus yet.
    UdisksPort();
    ~UdisksPort() override;

    [[nodiscard]] std::vector<StickEvent> poll(std::int64_t now_ns) override;

    void allow(FileSystems allowed) override { rules_.allow(allowed); }

    /// The following polls unmount the stick.
    void end_session() override;

    [[nodiscard]] bool is_watching() const override { return is_watching_; }

  private:
    class Bus;

    void connect(std::int64_t now_ns);
    void carry_out(const StickStep& step);
    void lose_service();

    std::unique_ptr<Bus> bus_;  // null: no bus
    StickRules rules_;
    std::vector<StickEvent> events_;
    std::int64_t next_try_ns_ = 0;
    bool is_watching_ = false;
};

}  // namespace touchline
