// A kiosk in real time, with all its parts except window and sound card. The device here asks for a
// block of 128 frames when a card would, two blocks ahead, and notes when the first audible one was
// rendered. What the card adds is not measured. Threads: one; the parts have their own.
#pragma once

#include "app/force/servo/servo_thread.h"
#include "app/kiosk/kiosk.h"
#include "app/sound/sound.h"
#include "config/types/pinned.h"
#include "config/types/steady_clock.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

namespace touchline {

class RealKiosk : private Pinned {
  public:
    /// `stick`: a folder that is offered as a stick is; empty: there is none.
    explicit RealKiosk(const std::string& stick = {});

    void run_for(std::int64_t time_ns);

    /// Frames go on meanwhile. Returns false if it took too long.
    template <class Condition>
    bool wait_until(const Condition& is_so) {
        const std::int64_t begin_ns = steady_now_ns();
        std::int64_t next_ns = begin_ns;
        while (!is_so()) {
            if (steady_now_ns() - begin_ns > longest_wait_ns) return false;
            if (steady_now_ns() >= next_ns) {
                kiosk_->step(steady_now_ns());
                next_ns += frame_ns;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
        return true;
    }

    void press(KeyRole role);

    /// Presses Down until the item with this number has the focus; at most a hundred times.
    void focus_on(std::size_t item);

    /// Returns the time from a key to the first audible frame.
    [[nodiscard]] double heard_after_ms(KeyRole role);

    /// Returns the time from a key to the first tick that feels another picture than before and may
    /// give force.
    [[nodiscard]] double felt_after_ms(KeyRole role);

    void choose_sounds(CueAmount amount);

    [[nodiscard]] Kiosk& kiosk() { return *kiosk_; }

    void stop() { kiosk_->stop(); }

  private:
    static constexpr std::int64_t frame_ns = 16'666'667;  // of the screen
    static constexpr std::int64_t longest_wait_ns = 20'000'000'000;

    void wait_for_silence();

    std::shared_ptr<std::atomic<std::int64_t>> heard_ns_ =
        std::make_shared<std::atomic<std::int64_t>>(0);
    ServoThread* servo_ = nullptr;  // owned by the kiosk
    Sound* sound_ = nullptr;        // owned by the kiosk
    std::unique_ptr<Kiosk> kiosk_;
};

}  // namespace touchline
