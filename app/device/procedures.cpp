#include "app/device/procedures.h"

#include "app/device/device_words.h"
#include "haptics/device/homing.h"
#include "haptics/pantograph/kinematics.h"

#include <cmath>
#include <utility>

namespace touchline {
namespace {

constexpr std::int64_t period_ns = 1'000'000;
constexpr double let_go_s = 2.0;         // to let go of a handle
constexpr double between_tries_s = 4.0;  // of the motors: for the words, and to let go
constexpr double middle_share = 0.6;     // of the drawing area

enum class Ending : std::uint8_t { finished, stopped, out_of_time, lost, misplaced };

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
        if (procedure.board.report().is_position_doubtful) ending = Ending::misplaced;
        if (procedure.board.report().state == BoardState::lost) ending = Ending::lost;
        if (ending != Ending::finished) break;
        const bool is_zero = *torques == JointTorques{};
        if (!is_zero) procedure.mark_force(true);
        if (procedure.board.write_torques(*torques) && is_zero) procedure.mark_force(false);
        schedule.finish(procedure.clock.now_ns());
    }
    if (!procedure.board.end_in_zero()) return Ending::lost;
    procedure.mark_force(false);
    return ending;
}

tl::unexpected<Error> failed(Ending ending, const std::string& what) {
    switch (ending) {
        case Ending::lost:
            return failure(what +
                           " ended: the board was unplugged or gave up; plug it in and try again");
        case Ending::misplaced:
            return failure(what + " ended: the handle has lost its place");
        case Ending::out_of_time:
            return failure(what + " ended: it took too long; try again");
        default:
            return failure(what + " was stopped");
    }
}

/// Zero torque for so long, or until `is_over(angles, dt_s)`.
template <class IsOver>
Ending wait(const Procedure& procedure, double longest_s, IsOver is_over) {
    double left_s = longest_s;
    return run_ticks(procedure, [&](const auto& angles, double dt_s) {
        left_s -= dt_s;
        const bool ends = !(left_s > 0.0) || is_over(angles, dt_s);
        return ends ? std::optional<JointTorques>() : JointTorques{};
    });
}

/// There each motor moves its own arm more than the other's.
bool is_in_the_middle(const DeviceProfile& profile, const std::optional<JointAngles>& angles) {
    const auto pose = angles ? forward(profile.geometry, *angles) : std::nullopt;
    if (!pose) return false;
    const Position p_W = picture_from_device(profile, pose->p_DH);
    return std::abs(p_W.x) <= 0.5 * middle_share * profile.area.width_m &&
           std::abs(p_W.y) <= 0.5 * middle_share * profile.area.height_m;
}

/// Until the handle has been in the middle for as long as it takes to let go of it. On the way
/// there from where the arms lie stretched a leap of the tip means nothing.
Ending lead_to_the_middle(const Procedure& procedure) {
    double there_s = 0.0;
    PantographBoard& board = procedure.board;
    return wait(procedure, procedure.longest_s, [&](const auto& angles, double dt_s) {
        if (board.report().state == BoardState::jumped) board.accept_position();
        const bool is_there = is_in_the_middle(board.frame().profile(), angles);
        there_s = is_there ? there_s + dt_s : 0.0;
        return there_s >= let_go_s;
    });
}

}  // namespace

Result<Homed> home(const Procedure& procedure, const Calibration& stored) {
    PantographBoard& board = procedure.board;
    const DeviceProfile& profile = board.frame().profile();
    Homing homing(homing_plan(profile), stored);
    board.set_calibration(homing.bare());
    HomingView said;
    procedure.say(words_of(said, profile));
    const Ending ending = run_ticks(procedure, [&](const auto& angles, double dt_s) {
        // Before the arms are known to be where they read, a leap of the tip means nothing.
        if (board.report().state == BoardState::jumped) board.accept_position();
        if (board.report().is_position_doubtful) {
            board.accept_position();
            homing.lose_count();
        }
        const HomingView view = homing.step(angles, dt_s);
        const bool is_new = view.prompts != said.prompts;
        said = view;
        if (is_new) procedure.say(words_of(view, profile));
        const bool is_over = view.step == HomingStep::done;
        return is_over ? std::optional<JointTorques>() : JointTorques{};
    });
    if (ending != Ending::finished) return failed(ending, "homing");
    board.set_calibration(homing.calibration());
    return Homed{board.frame().calibration(), said.remark == HomingRemark::measured};
}

Result<NudgeTest> nudge(const Procedure& procedure) {
    NudgeTest test(encoder_quantum(procedure.board.frame().calibrated_profile()));
    const Ending ending = run_ticks(procedure, [&](const auto& angles, double dt_s) {
        const JointTorques torques = test.step(angles, dt_s);
        const bool is_over = test.verdict() != NudgeVerdict::running;
        return is_over ? std::optional<JointTorques>() : torques;
    });
    if (ending != Ending::finished) return failed(ending, "the nudge test");
    return test;
}

Result<Calibration> try_motors(const Procedure& procedure, bool may_learn) {
    PantographBoard& board = procedure.board;
    procedure.say(words_of(NudgeVerdict::running, board.frame()));
    while (true) {
        if (const Ending ending = lead_to_the_middle(procedure); ending != Ending::finished)
            return failed(ending, "the test of the motors");
        const auto tried = nudge(procedure);
        if (!tried) return tl::unexpected(tried.error());
        if (tried->verdict() == NudgeVerdict::works) return board.frame().calibration();
        if (is_wrong(tried->verdict()) && std::exchange(may_learn, false)) {
            Calibration learnt = board.frame().calibration();
            learnt.motors = tried->motors(learnt.motors);
            board.set_calibration(learnt);
            continue;
        }
        procedure.say(words_of(tried->verdict(), board.frame()));
        const double pause_s = is_wrong(tried->verdict()) ? procedure.longest_s : between_tries_s;
        const Ending ending = wait(procedure, pause_s, [](const auto&, double) { return false; });
        if (ending != Ending::finished || is_wrong(tried->verdict()))
            return failed(ending, "the test of the motors");
    }
}

Result<Calibration> make_ready(const Procedure& procedure, const Calibration& stored) {
    const auto homed = home(procedure, stored);
    if (!homed) return tl::unexpected(homed.error());
    return try_motors(procedure, homed->is_new);
}

}  // namespace touchline
