#include "app/force/device/procedures.h"

#include "app/force/device/device_words.h"
#include "haptics/device/homing.h"
#include "haptics/pantograph/kinematics.h"

#include <cmath>
#include <limits>
#include <utility>

namespace touchline {
namespace {

constexpr std::int64_t period_ns = 1'000'000;
constexpr double let_go_s = 2.0;         // time to let go of a handle
constexpr double words_s = 5.0;          // time to say what to do
constexpr double between_tries_s = 6.0;  // of the motors: for the words, and to let go
constexpr double outside_s = 20.0;       // time outside the middle before the words repeat
constexpr double middle_share = 0.6;     // of the drawing area's width and height

enum class Ending : std::uint8_t { finished, stopped, out_of_time, lost, misplaced };

constexpr const char* motor_test = "the test of the motors";

/// Varies repeated words, for the same words twice are not heard where only a change is spoken.
class Speech {
  public:
    template <class Device>
    explicit Speech(const ProcedureOf<Device>& procedure) : say_(procedure.say) {}

    void say(const std::string& words) {
        last_ = words == last_ ? words_again(words) : words;
        say_(last_);
    }

  private:
    const std::function<void(const std::string&)>& say_;
    std::string last_;
};

bool is_lost(const PantographBoard& board) {
    return board.report().state == BoardState::lost;
}

bool is_lost(const MotorPantograph& motors) {
    return motors.report().state == DriveState::lost ||
           motors.report().state == DriveState::refused;
}

bool has_jumped(const PantographBoard& board) {
    return board.report().state == BoardState::jumped;
}

bool has_jumped(const MotorPantograph& motors) {
    return motors.report().state == DriveState::jumped;
}

const BoardFrame& frame_of(const PantographBoard& board) {
    return board.frame();
}

/// Serves for words alone: motor 1 is that of joint 1.
BoardFrame frame_of(const MotorPantograph& motors) {
    return {motors.frame().profile(), Calibration{}};
}

template <class Device>
std::int64_t end_of(const ProcedureOf<Device>& procedure) {
    return procedure.clock.now_ns() + static_cast<std::int64_t>(procedure.longest_s * 1e9);
}

/// Runs ticks until `step(angles, dt_s)` returns no torques, or until the end. Writes zero last.
template <class Device, class Step>
Ending run_ticks(const ProcedureOf<Device>& procedure, std::int64_t end_ns, Step step) {
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
        if (procedure.clock.now_ns() > end_ns) ending = Ending::out_of_time;
        if (procedure.board.report().is_position_doubtful) ending = Ending::misplaced;
        if (is_lost(procedure.board)) ending = Ending::lost;
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

template <class Device>
Ending wait(const ProcedureOf<Device>& procedure, std::int64_t end_ns, double pause_s) {
    return run_ticks(procedure, end_ns, [&](const auto&, double dt_s) {
        pause_s -= dt_s;
        return pause_s > 0.0 ? std::optional(JointTorques{}) : std::nullopt;
    });
}

/// In the middle each motor moves its own arm more than the other's.
bool is_in_the_middle(const DeviceProfile& profile, const std::optional<JointAngles>& angles) {
    const auto pose = angles ? forward(profile.geometry, *angles) : std::nullopt;
    if (!pose) return false;
    const Position p_W = picture_from_device(profile, pose->p_DH);
    return std::abs(p_W.x) <= 0.5 * middle_share * profile.area.width_m &&
           std::abs(p_W.y) <= 0.5 * middle_share * profile.area.height_m;
}

/// Runs until the handle has been in the middle for long enough to let go of it, and everything was
/// said. On the way there from the stretched arms, a jump of the tip means nothing.
template <class Device>
Ending lead_to_the_middle(const ProcedureOf<Device>& procedure, std::int64_t end_ns,
                          Speech& speech) {
    double there_s = 0.0, since_s = 0.0, away_s = 0.0;
    return run_ticks(procedure, end_ns, [&](const auto& angles, double dt_s) {
        Device& board = procedure.board;
        if (has_jumped(board)) board.accept_position();
        const bool is_there = is_in_the_middle(board.frame().profile(), angles);
        since_s += dt_s;
        there_s = is_there ? there_s + dt_s : 0.0;
        away_s = is_there ? 0.0 : away_s + dt_s;
        if (away_s >= outside_s) speech.say(words_outside_the_middle(frame_of(board)));
        if (away_s >= outside_s) away_s = 0.0;
        const bool is_over = there_s >= let_go_s && since_s >= words_s;
        return is_over ? std::nullopt : std::optional(JointTorques{});
    });
}

/// `before`: what was said last; it is said before what to do now.
template <class Device>
Result<NudgeTest> nudge(const ProcedureOf<Device>& procedure, std::int64_t end_ns, Speech& speech,
                        const std::string& before) {
    const BoardFrame& frame = frame_of(procedure.board);
    speech.say(before + words_of(NudgeVerdict::running, frame));
    if (const Ending ending = lead_to_the_middle(procedure, end_ns, speech);
        ending != Ending::finished)
        return failed(ending, motor_test);
    NudgeTest test(encoder_quantum(frame.calibrated_profile()));
    const Ending ending = run_ticks(procedure, end_ns, [&](const auto& angles, double dt_s) {
        const JointTorques torques = test.step(angles, dt_s);
        const bool is_over = test.verdict() != NudgeVerdict::running;
        return is_over ? std::optional<JointTorques>() : torques;
    });
    if (ending != Ending::finished) return failed(ending, motor_test);
    return test;
}

}  // namespace

Result<Homed> home(const Procedure& procedure, const Calibration& stored) {
    PantographBoard& board = procedure.board;
    const DeviceProfile& profile = board.frame().profile();
    Homing homing(homing_plan(profile), stored);
    board.set_calibration(homing.bare());
    HomingView said;
    Speech speech(procedure);
    speech.say(words_of(said, profile));
    const auto step = [&](const auto& angles, double dt_s) {
        // Until the arms are known to be where they read, a jump of the tip means nothing.
        if (board.report().state == BoardState::jumped) board.accept_position();
        if (board.report().is_position_doubtful) {
            board.accept_position();
            homing.lose_count();
        }
        const HomingView view = homing.step(angles, dt_s);
        const bool is_new = view.prompts != said.prompts;
        const bool is_over = view.step == HomingStep::done;
        said = view;
        if (is_new && !is_over) speech.say(words_of(view, profile));
        return is_over ? std::optional<JointTorques>() : JointTorques{};
    };
    const Ending ending = run_ticks(procedure, end_of(procedure), step);
    if (ending != Ending::finished) return failed(ending, "homing");
    board.set_calibration(homing.calibration());
    return Homed{board.frame().calibration(), said.remark == HomingRemark::measured,
                 words_of(said, profile)};
}

Result<NudgeTest> nudge(const Procedure& procedure, const std::string& before) {
    Speech speech(procedure);
    return nudge(procedure, end_of(procedure), speech, before);
}

Result<Calibration> try_motors(const Procedure& procedure, bool may_learn, std::string before) {
    PantographBoard& board = procedure.board;
    const std::int64_t end_ns = end_of(procedure);
    Speech speech(procedure);
    while (true) {
        const auto tried = nudge(procedure, end_ns, speech, std::exchange(before, {}));
        if (!tried) return tl::unexpected(tried.error());
        const NudgeVerdict verdict = tried->verdict();
        if (verdict == NudgeVerdict::works) return board.frame().calibration();
        if (is_wrong(verdict) && std::exchange(may_learn, false)) {
            Calibration learnt = board.frame().calibration();
            learnt.motors = tried->motors(learnt.motors);
            board.set_calibration(learnt);
            continue;
        }
        speech.say(words_of(verdict, board.frame()));
        const double pause_s =
            is_wrong(verdict) ? std::numeric_limits<double>::infinity() : between_tries_s;
        if (const Ending ending = wait(procedure, end_ns, pause_s); ending != Ending::finished)
            return failed(ending, motor_test);
    }
}

Result<void> try_motors(const MotorsProcedure& procedure) {
    const std::int64_t end_ns = end_of(procedure);
    const BoardFrame frame = frame_of(procedure.board);
    Speech speech(procedure);
    while (true) {
        const auto tried = nudge(procedure, end_ns, speech, {});
        if (!tried) return tl::unexpected(tried.error());
        const NudgeVerdict verdict = tried->verdict();
        if (verdict == NudgeVerdict::works) return {};
        if (is_wrong(verdict))
            return failure(
                "the motors moved other arms, or moved them the other way, than they were told: "
                "set "
                "up direction and order of the motors again");
        speech.say(words_of(verdict, frame));
        if (const Ending ending = wait(procedure, end_ns, between_tries_s);
            ending != Ending::finished)
            return failed(ending, motor_test);
    }
}

Result<Calibration> make_ready(const Procedure& procedure, const Calibration& stored) {
    const auto homed = home(procedure, stored);
    if (!homed) return tl::unexpected(homed.error());
    return try_motors(procedure, homed->is_new, homed->words + " ");
}

}  // namespace touchline
