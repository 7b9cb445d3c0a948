// The two motors of a five-bar, each with a controller of its own, whatever they are called and
// whatever carries the bytes. A pair knows its wire protocol and how to arm its controllers; the
// driver over it (motor_pantograph.h) knows joints, ages, limits and when to begin anew.
#pragma once

#include "config/types/pinned.h"
#include "haptics/device/drives/joint_drives.h"

#include <cstdint>
#include <optional>
#include <string>

namespace touchline {

/// setting_up: the controllers are being armed, and no motor has torque. ready: they follow.
/// astray: something came that should not; set_up() helps. refused: trouble() says why, and it
/// stays until set_up(). gone: unplugged.
enum class PairState : std::uint8_t { setting_up, ready, astray, refused, gone };

/// Why a pair gives no torque. `motor` is 1 or 2, `code` the controller's own.
struct MotorTrouble {
    enum class Kind : std::uint8_t {
        none,
        fault,             // the controller reports one, by its code
        watchdog_not_set,  // it does not confirm the watchdog that it was told
        not_let_go,        // it would damp or hold the motor when its watchdog expires
        no_encoder,        // it does not know where its shaft is
        not_calibrated,    // it does not know its motor yet
        too_old,           // its firmware lacks what is needed
        other_control,     // it keeps a control of its own, which changes what it is told
        silent             // it does not answer
    };
    Kind kind = Kind::none;
    int motor = 0;
    std::uint32_t code = 0;

    friend bool operator==(const MotorTrouble&, const MotorTrouble&) = default;
};

/// What a step brought.
struct PairNews {
    PairState state = PairState::setting_up;
    std::optional<ShaftTurns> turns;  // newer than any before, of one moment; finite
    double late_s = 0.0;              // of the turns, as Freshness
    bool is_held_zero = false;  // both confirmed that they hold zero torque or let their motors go,
                                // and nothing else was sent since
    bool is_let_go = false;     // both confirmed that their motors are let go, after let_go()
    std::uint64_t wrong = 0;    // what came that was no answer, since the pair was made
};

/// How long a controller goes on without word from here. Then it lets its motor go by itself.
inline constexpr double watchdog_s = 0.02;

/// Threads: one at a time. step(), tell() and set_up() neither wait nor allocate, lock or log.
class MotorPair : public Interface {
  public:
    /// Begins to arm both controllers: motors let go, watchdog set and read back, faults cleared,
    /// then zero torque. A fault that came since the pair was ready is told (refused) and not
    /// cleared unseen. Whatever was under way is forgotten.
    virtual void set_up() = 0;

    /// Takes what has come; elapsed_s >= 0 since the step before.
    [[nodiscard]] virtual PairNews step(double elapsed_s) = 0;

    /// Sends what belongs to this tick; call it once after each step. While the pair is ready that
    /// is `torques`; else what set_up() needs, or that the motors be let go, whatever `torques`.
    /// Returns false if it could not be sent.
    [[nodiscard]] virtual bool tell(ShaftTorques torques) = 0;

    /// Lets both motors go at the next tell() and from then on, until set_up().
    virtual void let_go() = 0;

    [[nodiscard]] virtual MotorTrouble trouble() const = 0;

    /// Says in one line what the trouble is, why, and what to do. Allocates.
    [[nodiscard]] virtual std::string words_of(const MotorTrouble& trouble) const = 0;

    /// True if the encoders say where the shafts are within a turn, not only how far they turned
    /// since the power came on. Known once the pair was ready.
    [[nodiscard]] virtual bool are_encoders_absolute() const = 0;

    /// Waits for span_s.
    virtual void rest(double span_s) = 0;
};

}  // namespace touchline
