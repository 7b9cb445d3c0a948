// The emulated service as an Inverse3Link in the same process, on a virtual clock, with faults at
// chosen answers. Threads: one at a time.
#pragma once

#include "haptics/device/inverse3/inverse3_link.h"
#include "tests/machines/sim/inverse3/service_emulator.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace touchline {

/// What goes wrong with the answer to a frame.
enum class AnswerFault : std::uint8_t {
    none,
    late,
    lost,
    cut,       // in the middle of the text
    garbled,   // a brace becomes a letter
    doubled,   // comes twice
    other_arm  // tells of devices of other names only
};

class EmulatedService final : public Inverse3Link {
  public:
    /// Both must outlive it; rest() moves `now_s` on. The service greets at once. The device is the
    /// one of that name; empty: the only one.
    EmulatedService(ServiceEmulator& service, double& now_s, std::string_view name = {});

    ~EmulatedService() override { close(); }

    [[nodiscard]] ArmNews news() override;
    void tell(const WantedArmForce& wanted) override;
    void rest(double span_s) override;

    [[nodiscard]] const Inverse3Session& session() const { return session_; }

    /// Of the next `count` answers.
    void spoil(AnswerFault fault, int count = 1, double late_s = 0.0);

    /// The service closes the conversation: frames on the way are lost.
    void close();

    /// As if the process that holds the link was stopped: nothing is sent or heard any more, and
    /// the conversation stays open.
    void freeze() { is_frozen_ = true; }

    /// Frames of ours so far.
    [[nodiscard]] std::size_t sent() const { return sent_; }

    static constexpr double way_s = 1.5e-4;  // of a frame

  private:
    struct OnTheWay {
        double at_s = 0.0;
        std::string text;
    };

    void catch_up(double t_s);
    void exchange(double t_s);
    void send_answer(const std::string& text, double at_s);

    ServiceEmulator& service_;
    double& now_s_;
    Inverse3Session session_;
    WantedArmForce wanted_;
    std::deque<OnTheWay> to_service_, to_client_;
    double caught_up_s_;
    AnswerFault fault_ = AnswerFault::none;
    int faults_left_ = 0;
    double late_s_ = 0.0;
    bool is_closed_ = false;
    bool is_frozen_ = false;
    std::size_t sent_ = 0;
};

}  // namespace touchline
