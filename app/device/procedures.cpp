#include "app/device/procedures.h"

#include "app/device/device_words.h"
#include "haptics/device/homing.h"

#include <cmath>

namespace touchline {
namespace {

constexpr std::int64_t period_ns = 1'000'000;

enum class Ending : std::uint8_t { finished, stopped, out_of_time, lost };

/// Ticks until `step(angles, dt_s)` gives no torques. The last thing written is zero.
template <class Step>
Ending run_ticks(const Procedure& procedure, Step step) {
    TickSchedule schedule(procedure.clock.now_ns(), period_ns);
    double last_s = 0.0;
    Ending ending = Ending::finished;
    while (true) {
        procedure.clock.sleep_until(schedule.due_ns());
        const double now_s = schedule.due_s();
        const auto angles = procedure.board.read_angles(now_s);
        const std::optional<JointTorques> torques = step(angles, now_s - last_s);
        last_s = now_s;
        if (!torques) break;
        if (!procedure.goes_on()) ending = Ending::stopped;
        if (now_s > procedure.longest_s) ending = Ending::out_of_time;
        if (procedure.board.report().state == BoardState::lost) ending = Ending::lost;
        if (ending != Ending::finished) break;
        (void)procedure.board.write_torques(*torques);
        schedule.finish(procedure.clock.now_ns());
    }
    (void)procedure.board.end_in_zero();
    return ending;
}

tl::unexpected<Error> failed(Ending ending, const std::string& what) {
    switch (ending) {
        case Ending::lost:
            return failure(what +
                           " ended: the board was unplugged or gave up; plug it in and try again");
        case Ending::out_of_time:
            return failure(what + " ended: it took too long; try again");
        default:
            return failure(what + " was stopped");
    }
}

}  // namespace

Result<Calibration> home(const Procedure& procedure, const std::optional<Calibration>& stored) {
    const DeviceProfile& profile = procedure.board.frame().profile();
    Homing homing(homing_plan(profile), stored);
    procedure.board.set_calibration(homing.bare());
    HomingView said;
    procedure.say(words_of(said, profile));
    bool is_reopened = true;
    const Ending ending = run_ticks(procedure, [&](const auto& angles, double dt_s) {
        // Before the arms are known to be where they read, a leap of the tip means nothing.
        if (procedure.board.report().state == BoardState::jumped) procedure.board.accept_position();
        if (procedure.board.report().is_position_doubtful) {
            procedure.board.accept_position();
            homing.lose_count();
        }
        const HomingView view = homing.step(angles, dt_s);
        const bool is_new = view.prompts != said.prompts;
        said = view;
        if (is_new) procedure.say(words_of(view, profile));
        if (is_new && view.remark == HomingRemark::swapped) {
            is_reopened = procedure.board.open(homing.bare()).has_value();
        }
        const bool is_over = view.step == HomingStep::done || !is_reopened;
        return is_over ? std::optional<JointTorques>() : JointTorques{};
    });
    if (ending != Ending::finished || !is_reopened)
        return failed(is_reopened ? ending : Ending::lost, "homing");
    procedure.board.set_calibration(homing.calibration());
    return homing.calibration();
}

Result<NudgeVerdict> nudge(const Procedure& procedure) {
    NudgeTest test(encoder_quantum(procedure.board.frame().profile()));
    procedure.say(words_of(test.verdict()));
    const Ending ending = run_ticks(procedure, [&](const auto& angles, double dt_s) {
        const JointTorques torques = test.step(angles, dt_s);
        const bool is_over = test.verdict() != NudgeVerdict::running;
        return is_over ? std::optional<JointTorques>() : torques;
    });
    if (ending != Ending::finished) return failed(ending, "the nudge test");
    return test.verdict();
}

}  // namespace touchline
