// The operator at the kiosk: carries out the screens' orders to servo, sound, camera and stick.
#include "app/kiosk/kiosk.h"
#include "app/visit/told_lines.h"

#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// Carries out each order of the operator.
struct Kiosk::OperatorOrderHandler {
    Kiosk& kiosk;

    void operator()(const Say& say) const {
        kiosk.operator_caption_ = say.text;
        kiosk.say({kiosk.language().code(), say.text, SpeechPriority::text});
    }

    void operator()(const Click&) const { kiosk.sound_->give(ScreenEvent::key_taken); }

    void operator()(const Show& show) const { kiosk.operator_caption_ = show.text; }

    void operator()(const SetSettings&) const { kiosk.set(kiosk.operator_->settings()); }

    void operator()(const WriteSettings&) const { kiosk.set(kiosk.operator_->settings()); }

    void operator()(const WriteSound& write) const {
        kiosk.sound_->set_levels(write.sound, 0.0);
        kiosk.hours_.look_again();
    }

    void operator()(const WriteKeys& write) const { kiosk.keys_.table = write.keys; }

    void operator()(const FindHome&) const { kiosk.handle_.servo().home_again(); }

    void operator()(const ChooseKind& kind) const {
        kiosk.handle_.servo().choose_kind(kind.profile);
    }

    void operator()(const ClearFault&) const { kiosk.act(Action::clear_fault); }

    void operator()(const RunTest& run) const { kiosk.run_test(run.step); }

    void operator()(const ShowLive& show) const {
        kiosk.window_wishes_.shows_live_view = show.is_on;
    }

    void operator()(const LockHandle& lock) const { kiosk.handle_.lock(lock.is_on); }

    void operator()(const SaveRecording&) const { kiosk.handle_.keep_recording(); }

    void operator()(const KeepDrawing&) const { kiosk.keep_drawing(); }

    void operator()(const CloseKiosk&) const { kiosk.window_wishes_.is_quitting = true; }

    /// After the operator's last words, says the visitors' screen. A PIN cannot be paged back to.
    void operator()(const Leave&) const {
        kiosk.window_wishes_.shows_live_view = false;
        kiosk.braille_->forget();
        kiosk.say({kiosk.language().code(), spoken_screen(kiosk.screen(), kiosk.language()),
                   SpeechPriority::hint});
    }

    /// The session has carried out all others itself; a test that is stopped has ended at once.
    template <class Order>
    void operator()(const Order&) const {}
};

SpokenScreen Kiosk::screen() const {
    return is_operator_in() ? operator_->screen(language()) : screen_of(visit_, world());
}

const std::string& Kiosk::caption() const {
    if (is_operator_in()) return operator_caption_;
    return key_caption_.empty() ? visit_.visitor.caption.text : key_caption_;
}

void Kiosk::tell_operator(const OperatorEvent& event) {
    if (!operator_) return;
    const auto* const key = std::get_if<KeyStruck>(&event);
    const bool was_in = is_operator_in();
    if (key != nullptr && key->is_allowed && was_in) {
        sound_->hush();
        sound_->give(ScreenEvent::key_taken);
    }
    for (const OperatorOrder& order : operator_->apply(event, language(), now_s_))
        std::visit(OperatorOrderHandler{*this}, order);
}

void Kiosk::tell_of_recording(const std::string& notice) {
    const auto is_kept = handle_.is_recording_kept(notice);
    if (!is_kept) return;
    tell_operator(OrderAnswered{language().text(
        "operator", *is_kept ? "The recording is saved. The log says where."
                             : "The recording could not be saved. The log says why.")});
}

/// What is felt now is what is kept.
void Kiosk::keep_drawing() {
    const TactileMap* const map = picture_.map();
    const bool is_drawn = visit_.visitor.drawing && map != nullptr && !map->outlines.empty();
    tell_operator(OrderAnswered{is_drawn
                                    ? operator_->keep_drawing(*map, language())
                                    : language().text("operator", "There is no drawing to keep.")});
}

void Kiosk::count_visit() {
    const auto length_s = length_.step(is_visit_on(visit_), now_s_);
    if (length_s && operator_) operator_->count_visit(*length_s / 60.0, today());
}

/// Opens, closes and softens the kiosk by the site's clock.
void Kiosk::follow_hours() {
    const auto now = hours_.look(now_s_, settings_);
    if (!now) return;
    tell(now->change);
    rules_.invites = !now->is_quiet;
    if (operator_)
        sound_->set_levels(operator_->sound(), now->is_quiet ? settings_.quiet_lower_dB : 0.0);
}

void Kiosk::follow_operator() {
    if (!operator_) return;
    handle_.follow_motor_test();
    operator_->count_faults(faults_.step({is_force_faulty(), !sound_->problem().empty(),
                                          watched_.is_in_trouble(TroubleKind::camera)}),
                            today(), now_s_);
    ready_.step(!handle_.servo().device_words().empty(), now_s_);
    operator_->see({sound_->are_headphones_in().value_or(false), live_words(),
                    handle_.servo().kind(), felt_bounds(),
                    told_of_device(handle_.servo().device_words(), language(), ToldTo::staff),
                    today(), health()});
    if (sticks_) operator_->put_stick(sticks_->root());
    if (const auto line = operator_->poll_stick(language())) tell_operator(OrderAnswered{*line});
    for (const OperatorEvent& event : operator_->poll_house()) tell_operator(event);
    tell_operator(MomentPassed{});
    if (const std::string note = operator_->take_note(); !note.empty()) report(note);
    if (operator_->read_again()) set(operator_->settings());
}

void Kiosk::run_test(TestStep step) {
    if (step == TestStep::keys) return;  // the screens count them
    const bool has_passed = passes(step);
    const bool is_of_handle = step == TestStep::device || step == TestStep::motors;
    tell_operator(TestAnswered{step, has_passed, is_of_handle ? staffs_words() : ""});
}

std::chrono::sys_days Kiosk::today() const {
    return today_ ? today_() : std::chrono::sys_days{};
}

/// Pressing the emergency stop is no fault.
bool Kiosk::is_force_faulty() const {
    return force().fault != Fault::none && force().fault != Fault::emergency_stop;
}

/// What is wrong with the handle or under way there; empty: nothing.
std::string Kiosk::staffs_words() const {
    return describe(live_facts(), hand(), force(), language()).message;
}

bool Kiosk::is_handle_live() const {
    return force().fault == Fault::none && hand().ticks > 0 &&
           handle_.servo().device_words().empty();
}

KioskHealth Kiosk::health() const {
    KioskHealth health;
    health.handle = language().text("panel", device_facts_.hand_words, {device_facts_.hand_name});
    if (!is_handle_live()) health.handle_trouble = staffs_words();
    if (!is_handle_live() && health.handle_trouble.empty())
        health.handle_trouble = language().text("trouble", std::string(staffs_device_trouble));
    health.has_motors = handle_.servo().kind().has_value();
    if (const auto ready_s = ready_.since_s()) health.homed_ago_s = now_s_ - *ready_s;
    health.has_sound = sound_->problem().empty();
    health.is_on_headphones = sound_->output().kind == OutputKind::headset;
    if (photos_)
        health.camera = watched_.is_in_trouble(TroubleKind::camera) ? CameraHealth::stopped
                        : watched_.has_camera()                     ? CameraHealth::ready
                                                                    : CameraHealth::unplugged;
    health.notices_sticks = !sticks_ || sticks_->is_watching();
    health.has_stick = sticks_ && !sticks_->root().empty();
    if (printer_) health.printer = printer_->condition();
    health.started_ago_s = now_s_ - started_s_.value_or(now_s_);
    return health;
}

bool Kiosk::passes(TestStep step) {
    switch (step) {
        case TestStep::device:
            return force().fault == Fault::none && hand().ticks > 0;
        case TestStep::camera:
            return watched_.has_camera();
        case TestStep::stick_port:
            return sticks_ && sticks_->is_watching();
        case TestStep::disk:
            return operator_->can_write();
        case TestStep::motors:  // a person tells whether it was felt
            if (!is_handle_live()) return false;
            handle_.begin_motor_test();
            break;
        case TestStep::sound_left:
        case TestStep::sound_right:
            sound_->play_side(step == TestStep::sound_left);
            break;
        case TestStep::keys:
            break;
    }
    return true;
}

/// The bounds of a level depend on the picture: without a line there are none.
FeltBounds Kiosk::felt_bounds() const {
    FeltBounds bounds{hand().stiffness_bound, std::nullopt};
    const TactileMap* const map = picture_.map();
    if (map != nullptr && !map->outlines.empty()) bounds.levels = hand().level_terms;
    return bounds;
}

std::vector<std::string> Kiosk::live_words() const {
    Status status = describe(live_facts(), hand(), force(), language());
    std::vector<std::string> words;
    if (!status.message.empty()) words.push_back(std::move(status.message));
    for (const StatusLine& line : status.lines) words.push_back(line.name + ": " + line.value);
    return words;
}

}  // namespace touchline
