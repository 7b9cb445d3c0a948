// The people at the site, and what goes wrong there.
#include "tests/machines/sim/kiosk/house.h"
#include "tests/machines/sim/kiosk/sim_house.h"

#include <algorithm>
#include <fstream>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr double wire_is_broken_s = 0.08;  // by then all packets have arrived or are lost
constexpr double board_looks_s = 1e-3;     // the next tick can see a link fault
constexpr double longest_unnoticed_s = 6e-3;
constexpr double guard_gives_up_s = 0.5;  // on a kiosk whose main thread is stuck
constexpr double job_s = 0.03;            // a usual load job
constexpr double staff_comes_s = 1.0;
constexpr double staff_takes_s = 3.0;
constexpr std::uint64_t of_drawer = 6;
constexpr std::uint64_t of_reader = 7;
constexpr double staff_homes = 0.04;  // chance that they home the device before a visit

}  // namespace

void SimHouse::follow_plan() {
    for (std::size_t i = 0; i < ongoing_.size();) {
        if (now_s_ < ongoing_[i].until_s) {
            ++i;
            continue;
        }
        const SimFault fault = ongoing_[i].fault;
        ongoing_.erase(ongoing_.begin() + static_cast<std::ptrdiff_t>(i));
        end(fault);
    }
    while (next_cause_ < plan_.causes.size() && plan_.causes[next_cause_].at_s <= now_s_)
        begin(plan_.causes[next_cause_++]);
}

void SimHouse::begin(const PlannedCause& cause) {
    const SimFaultKind& kind = kind_of(cause.fault);
    const bool is_done = kind.link != LinkFault::none                    ? break_link(cause)
                         : cause.fault <= SimFault::machine_stands_still ? break_servo(cause)
                         : cause.fault <= SimFault::handle_thrown        ? break_kiosk(cause)
                                                                         : break_house(cause);
    if (is_done) ++figures_.fired[static_cast<std::size_t>(cause.fault)];
}

/// Torque that is on now must be off in time; without torque there is nothing to check.
void SimHouse::expect_zero(SimFault fault, double after_s) {
    if (board_.plant().torques() == JointTorques{}) return;
    ++figures_.pressed[static_cast<std::size_t>(fault)];
    zero_deadline_.expect(fault, time_.now_s + after_s);
}

bool SimHouse::break_link(const PlannedCause& cause) {
    if (!servo_ || !servo_->is_ticking() || servo_->link() == nullptr) return false;
    const LinkFault link = kind_of(cause.fault).link;
    // A reply that is late by less than this may go unnoticed.
    const bool is_short = cause.span_s > 0.0 && cause.span_s < longest_unnoticed_s;
    if (!is_short) expect_zero(cause.fault, board_looks_s);
    servo_->link()->spoil_next({0, link, cause.span_s, cause.seed});
    link_broken_until_s_ = time_.now_s + wire_is_broken_s + cause.span_s;
    const bool is_unplugged =
        link == LinkFault::unplugged_before || link == LinkFault::unplugged_after;
    if (is_unplugged) ongoing_.push_back({cause.fault, now_s_ + cause.span_s});
    return true;
}

bool SimHouse::break_servo(const PlannedCause& cause) {
    if (!servo_ || !servo_->is_ticking()) return false;
    if (cause.fault == SimFault::angle_not_a_number) {
        servo_->break_next_angle();
        expect_zero(cause.fault);
        return true;
    }
    late_s_ = cause.span_s;
    is_machine_still_ = cause.fault == SimFault::machine_stands_still;
    link_broken_until_s_ = time_.now_s + wire_is_broken_s + cause.span_s;
    expect_zero(cause.fault);
    return true;
}

/// Causes faults of processes and people.
bool SimHouse::break_kiosk(const PlannedCause& cause) {
    const double until_s = now_s_ + cause.span_s;
    if (!is_kiosk_up() || !servo_) return false;
    switch (cause.fault) {
        case SimFault::kiosk_frozen:
            kiosk_frozen_until_s_ = until_s;
            expect_zero(cause.fault);
            break;
        case SimFault::kiosk_hangs:
            expect_zero(cause.fault, guard_gives_up_s);
            frames_off_until_s_ = until_s;
            break;
        case SimFault::screen_starved:
            frames_off_until_s_ = until_s;
            break;
        case SimFault::kiosk_killed:
            is_kiosk_dying_ = true;
            is_end_wanted_ = true;
            kiosk_frozen_until_s_ = until_s;
            servo_->hang_up();
            expect_zero(cause.fault);
            break;
        case SimFault::servo_killed:
            if (!servo_->is_ticking()) return false;
            is_kill_wanted_ = true;
            expect_zero(cause.fault);
            return true;
        case SimFault::servo_frozen:
            if (!servo_->is_ticking()) return false;
            is_servo_frozen_ = true;
            expect_zero(cause.fault);
            return true;
        case SimFault::emergency_stop:
            kiosk_->press(Key{'E'});
            expect_zero(cause.fault);
            break;
        case SimFault::hand_off:
            if (!visitor_) return false;
            visitor_->lose_grip(until_s);
            break;
        case SimFault::handle_thrown:
            if (!visitor_ || !visitor_->holds_handle()) return false;
            visitor_->throw_handle({*kiosk_->kiosk, board_, *hand_, *kiosk_->sticks,
                                    kiosk_->servo->felt, now_s_, time_.now_s, false},
                                   1.0 + 3.0 * cause.span_s);
            break;
        default:
            return false;
    }
    ongoing_.push_back({cause.fault, until_s});
    return true;
}

bool SimHouse::break_house(const PlannedCause& cause) {
    if (!is_kiosk_up()) return false;
    switch (cause.fault) {
        case SimFault::decoder_hangs:
        case SimFault::decoder_crashes:
        case SimFault::decoder_lies:
        case SimFault::decoder_slow:
            armed_decoder_ = cause.fault;
            armed_decoder_s_ = cause.span_s;
            return false;  // counted once a job meets it
        case SimFault::stick_yanked:
            if (!kiosk_->sticks->is_in())
                kiosk_->sticks->put(gallery_without_workers().files.front(), 0.5);
            break;
        case SimFault::camera_lost:
            kiosk_->camera->condition =
                cause.seed % 2 == 0 ? CameraCondition::absent : CameraCondition::stopped;
            break;
        case SimFault::disk_full:
            fill_disk(true);
            break;
        case SimFault::clock_step:
            minutes_stepped_ = static_cast<int>(cause.seed % (24 * 60));
            break;
        case SimFault::settings_corrupt:
            spoil_settings(true);
            break;
        case SimFault::sound_lost:
            heard_->problem = "No sound can be played. Check the plug of the headphones.";
            break;
        case SimFault::headphones_out:
            heard_->headphones = false;
            break;
        default:
            return false;
    }
    ongoing_.push_back({cause.fault, now_s_ + cause.span_s});
    return true;
}

void SimHouse::end(SimFault fault) {
    switch (fault) {
        case SimFault::unplugged_before:
        case SimFault::unplugged_after:
            if (!board_.is_plugged()) board_.plug();
            return;
        case SimFault::kiosk_frozen:
        case SimFault::kiosk_hangs:
        case SimFault::screen_starved:
            return answers_.excuse(now_s_);
        case SimFault::stick_yanked:
            if (kiosk_) kiosk_->sticks->pull();
            return;
        case SimFault::camera_lost:
            if (kiosk_) kiosk_->camera->condition = CameraCondition::ready;
            return;
        case SimFault::disk_full:
            return fill_disk(false);
        case SimFault::clock_step:
            minutes_stepped_ = 0;
            return;
        case SimFault::settings_corrupt:
            return spoil_settings(false);
        case SimFault::sound_lost:
            heard_->problem.clear();
            return;
        case SimFault::headphones_out:
            heard_->headphones = true;
            return;
        default:
            return;
    }
}

/// Replaces the folder by a file, so that nothing can be written below it.
void SimHouse::fill_disk(bool is_full) {
    const fs::path site = folder_ / "site";
    const fs::path away = folder_ / "site-away";
    std::error_code error;
    if (is_full) {
        fs::rename(site, away, error);
        std::ofstream(site) << "full\n";
    } else {
        fs::remove(site, error);
        fs::rename(away, site, error);
    }
}

void SimHouse::spoil_settings(bool are_spoiled) {
    const fs::path file = folder_ / "site" / "kiosk.toml";
    std::error_code error;
    if (are_spoiled)
        std::ofstream(file) << "[feel\nstiffness = \x01 nan 1e999\n";
    else
        fs::remove(file, error);
    if (!are_spoiled) write_settings();
}

/// The site's own. One that offers nothing beside has no file.
void SimHouse::write_settings() const {
    const SiteOffers& offers = plan_.offers;
    if (!offers.drawing && !offers.printer) return;
    std::ofstream file(folder_ / "site" / "kiosk.toml");
    if (offers.drawing) file << "[feel]\noffers_drawing = true\n";
    if (offers.printer) file << "[print]\nprinter = 'sheets'\n";
}

JobFate SimHouse::fate_of_job() {
    if (sabotage_ == Sabotage::lost_jobs) return {1e9, {}};
    if (!armed_decoder_) return {dice_.between(0.3 * job_s, 3.0 * job_s), {}};
    const SimFault fault = *armed_decoder_;
    armed_decoder_.reset();
    ++figures_.fired[static_cast<std::size_t>(fault)];
    switch (fault) {
        case SimFault::decoder_hangs:
            return {armed_decoder_s_, "the file took too long to open; choose another one"};
        case SimFault::decoder_crashes:
            return {armed_decoder_s_, "the file cannot be opened; choose another one"};
        case SimFault::decoder_lies:
            return {armed_decoder_s_, "the file could not be opened safely; choose another one"};
        default:
            return {armed_decoder_s_, {}};
    }
}

/// Lets a visitor come, press and move.
void SimHouse::welcome() {
    if (!visitor_ && next_visit_ < plan_.visits.size() &&
        plan_.visits[next_visit_].at_s <= now_s_) {
        const PlannedVisit& visit = plan_.visits[next_visit_++];
        visitor_.emplace(visit);
        if (visit.draws) drawer_.emplace(Dice::of(visit.seed, of_drawer).next());
        if (visit.reads) reader_.emplace(Dice::of(visit.seed, of_reader).next());
        ++figures_.visits;
        if (dice_.is_hit(staff_homes)) kiosk_->press(Key{'O'});
    }
    if (!visitor_) return;
    const VisitorPlace place{
        *kiosk_->kiosk,      board_, *hand_,      *kiosk_->sticks,
        kiosk_->servo->felt, now_s_, time_.now_s, !is_servo_ready() && ongoing_.empty()};
    const auto role = visitor_->act(place);
    if (visitor_->is_gone()) {
        visitor_.reset();
        if (drawer_) figures_.strokes += drawer_->strokes();
        if (reader_) figures_.turned_pages += reader_->turned();
        drawer_.reset();
        reader_.reset();
        if (kiosk_->braille) kiosk_->braille->is_plugged_in = false;
        kiosk_->sticks->pull();
        return;
    }
    if (!role) return;
    ++figures_.keys;
    answers_.ask(now_s_, heard_ever());
    press(*role);
}

/// On the keypad or on the braille display.
void SimHouse::press(KeyRole role) {
    const auto& line = kiosk_->braille;
    reader_&& line && reader_->takes_key(*line) ? line->press(role) : kiosk_->press(role);
}

/// Those who are with the visitor, until the visitor leaves.
void SimHouse::accompany() {
    if (!visitor_ || visitor_->is_leaving(now_s_)) return;
    if (drawer_) drawer_->act(*kiosk_, now_s_);
    has_read_ = reader_ && kiosk_->braille && reader_->act(*kiosk_->braille, now_s_);
}

/// Clears what only a person may clear, some seconds later.
void SimHouse::staff() {
    const bool is_pressed = std::ranges::any_of(
        ongoing_, [](const Ongoing& ongoing) { return ongoing.fault == SimFault::emergency_stop; });
    if (!needs_staff() || is_pressed) {
        staff_due_s_.reset();
        return;
    }
    if (!staff_due_s_) staff_due_s_ = now_s_ + dice_.between(staff_comes_s, staff_takes_s);
    if (now_s_ < *staff_due_s_) return;
    staff_due_s_.reset();
    kiosk_->press(Key{'C'});
}

}  // namespace touchline
