#include "app/kiosk/kiosk.h"

#include "app/kiosk/picture_facts.h"
#include "app/loading/kiosk_stages.h"
#include "app/session/fault_words.h"
#include "app/session/proxy_radius.h"
#include "app/session/told_lines.h"
#include "app/sticks/stick_words.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/words/guidance_words.h"
#include "config/types/plain_line.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double tick_s = 0.05;    // the visit's tick
constexpr double sign_s = 1.0;     // how long the sign of a sound stays
constexpr double moved_m = 0.002;  // a smaller motion is no sign of a person
constexpr double tour_m_per_s = 0.035;

/// The index of the language with this code; 0 if there is none.
std::size_t place_of(const std::string& code, const std::vector<Language>& languages) {
    const auto at = std::ranges::find_if(
        languages, [&code](const Language& language) { return language.code() == code; });
    return at == languages.end() ? 0 : static_cast<std::size_t>(at - languages.begin());
}

}  // namespace

/// Carries out each order of a visit.
struct Kiosk::VisitOrderHandler {
    Kiosk& kiosk;

    /// The visit is silent while the operator is in.
    void operator()(const Utterance& utterance) const {
        if (kiosk.is_operator_in() && utterance.priority != SpeechPriority::safety) return;
        kiosk.sound_->say(utterance);
    }

    void operator()(const Hush&) const { kiosk.sound_->hush(); }

    void operator()(const HoldSpeech&) const { kiosk.sound_->toggle_pause(); }

    void operator()(const GiveCue& cue) const {
        if (kiosk.is_operator_in()) return;
        kiosk.sound_->give(cue.event);
        kiosk.sign_ = cue.event;
        kiosk.signed_s_ = kiosk.now_s_;
    }

    void operator()(const GivePattern& pattern) const {
        if (kiosk.is_operator_in()) return;
        kiosk.pattern_.pattern = pattern.pattern;
        ++kiosk.pattern_.serial;
        kiosk.set_servo();
    }

    void operator()(const LoadPicture& order) const { kiosk.load(order); }

    /// A better version of it does not come later either.
    void operator()(const CancelLoad&) const {
        kiosk.loader_->cancel();
        kiosk.stay_with_felt();
    }

    void operator()(const Feel& feel) const {
        kiosk.feel_ = feel;
        kiosk.set_servo();
    }

    void operator()(const Guide& guide) const { kiosk.guide(guide); }

    void operator()(const CameraPreview& preview) const {
        kiosk.is_previewing_ = preview.is_on;
        if (kiosk.photos_) kiosk.photos_->show(preview.is_on);
    }

    void operator()(const Capture&) const {
        if (kiosk.photos_) kiosk.photos_->take();
    }

    void operator()(const GiveStickBack&) const {
        if (kiosk.sticks_) kiosk.sticks_->end_session();
    }

    void operator()(const Wipe&) const { kiosk.wipe(); }

    void operator()(const SoundWanted& wanted) const { kiosk.sound_->choose(wanted); }

    void operator()(const LookWanted&) const {}  // the screen asks the visit

    void operator()(const CallStaff&) const {}  // the same
};

Kiosk::Kiosk(KioskParts parts)
    : languages_(std::move(parts.languages)),
      pictures_(std::move(parts.gallery)),
      servo_(std::move(parts.servo)),
      sound_(std::move(parts.sound)),
      loader_(std::move(parts.loader)),
      sticks_(std::move(parts.sticks)),
      photos_(std::move(parts.photos)),
      settings_(std::move(parts.settings)),
      profile_(std::move(parts.profile)),
      hand_words_(std::move(parts.hand_words)),
      hand_name_(std::move(parts.hand_name)),
      reading_language_(std::move(parts.reading_language)),
      operator_(std::move(parts.operator_session)),
      are_keys_always_free_(parts.are_keys_free),
      minute_of_day_(std::move(parts.minute_of_day)),
      keys_(std::move(parts.keys)),
      filter_(settings_.double_strike_s) {
    follow_rules();
    rules_.has_camera = photos_ != nullptr;
    rules_.has_stick_port = sticks_ != nullptr;
    take(start_visit(world()));
}

void Kiosk::apply(const VisitEvent& event) {
    take(touchline::step(visit_, event, world()));
}

void Kiosk::take(VisitStep step) {
    visit_ = std::move(step.visit);
    for (const VisitOrder& order : step.orders) std::visit(VisitOrderHandler{*this}, order);
    if (reading_language_) *reading_language_ = written_language(language().code());
}

void Kiosk::set(const Settings& settings) {
    if (settings.double_strike_s != settings_.double_strike_s)
        filter_ = KeyFilter(settings.double_strike_s);
    const Settings before = std::exchange(settings_, settings);
    follow_rules();
    apply(SettingsChanged{before});
    set_servo();
}

void Kiosk::follow_rules() {
    const HeardOutput output = sound_->output();
    rules_.volume_steps = output.volume_steps;
    rules_.sound.volume = output.first_volume;
    rules_.sound.amount = settings_.sounds;
    rules_.sound.is_speech_on = settings_.is_speech_on;
    rules_.sound.rate = static_cast<std::size_t>(settings_.speech_rate - 1);
    rules_.sound.language = place_of(settings_.first_language, languages_);
    rules_.look.text_size = static_cast<std::size_t>(settings_.text_size);
    rules_.look.palette = static_cast<std::size_t>(settings_.palette);
    rules_.quiet_s = settings_.inactivity_s;
    rules_.answer_s = settings_.answer_s;
    rules_.offers_staff = settings_.offers_staff;
    rules_.notice = settings_.notice;
    if (sticks_)
        sticks_->allow(settings_.more_file_systems ? FileSystems::more : FileSystems::usual);
    if (photos_)
        photos_->set({settings_.cut_left_percent, settings_.cut_right_percent,
                      settings_.cut_top_percent, settings_.cut_bottom_percent});
}

void Kiosk::set_servo() {
    ServoCommands commands;
    ContactSettings& contact = commands.contact;
    contact.mode = feel_.mode;
    contact.stiffness_N_per_m =
        stiffness_steps.at(feel_.stiffness).share * settings_.stiffness_N_per_m;
    contact.radius_m = proxy_radius_m;
    contact.pop_through_N = settings_.has_pop_through ? settings_.pop_through_N : 0.0;
    contact.friction = settings_.friction;
    contact.capture_m = settings_.capture_mm / 1000.0;
    commands.finest_level = settings_.finest_level;
    commands.coarsest_level = settings_.coarsest_level;
    commands.is_level_auto = settings_.is_level_automatic;
    commands.level = settings_.fixed_level;
    commands.is_force_wanted = (feel_.is_force_wanted || is_motor_test_on()) && !is_handle_locked_;
    commands.force_ceiling_N = settings_.force_ceiling_N;
    commands.guidance = guidance_;
    commands.pattern = pattern_;
    commands.is_emergency_stop = is_emergency_stop_;
    commands.faults_cleared = faults_cleared_;
    commands.shape = feel_.shape;
    commands.turn_rad = feel_.turn_rad;
    servo_->set(commands);
}

/// Another part or detail of what a visitor brought comes from that same file, whatever is at its
/// place in the list by now.
FilePtr Kiosk::file_of_order(const LoadPicture& order) const {
    const auto& loading = visit_.visitor.loading;
    const bool is_again = loading && loading->order.request == order.request &&
                          loading->reason != LoadReason::other_picture;
    const bool is_visitors =
        order.source == PictureSource::stick || order.source == PictureSource::camera;
    return is_again && is_visitors && felt_file_ ? felt_file_ : pictures_.of(order);
}

void Kiosk::load(const LoadPicture& order) {
    order_ = order;
    const FilePtr file = file_of_order(order);
    if (file == nullptr) {
        apply(PictureFailed{order.request, language().text("kiosk",
                                                           "This picture is gone. "
                                                           "Choose another one.")});
        return;
    }
    wanted_ = file;
    is_loading_ = true;
    const Zoom zoom{order.zoom.centre, order.zoom.factor};
    loader_->want(order.request,
                  {file, order.page, order.view, {order.detail, zoom}, order.thing_at});
}

void Kiosk::stay_with_felt() {
    is_loading_ = false;
    order_ = felt_order_;
    wanted_ = felt_file_;
}

void Kiosk::guide(const Guide& guide) {
    ++guidance_.serial;
    guidance_.kind = GuidanceKind::none;
    guidance_.place = guide.place_W;
    guidance_.outline = -1;
    guidance_.speed_m_per_s = tour_m_per_s;
    is_guiding_ = guide.kind != GuideKind::stop;
    if (guide.kind == GuideKind::outline) {
        guidance_.kind = GuidanceKind::tour;
        guidance_.outline = guide.outline;
    } else if (guide.kind == GuideKind::to_place) {
        guidance_.kind = GuidanceKind::to_place;
    } else if (guide.kind == GuideKind::bring_back) {
        guidance_.kind = GuidanceKind::to_line;
    }
    set_servo();
}

void Kiosk::wipe() {
    is_loading_ = false;
    loader_->forget();
    pictures_.forget();
    if (photos_) photos_->forget();
    sound_->forget();
    wanted_.reset();
    felt_file_.reset();
    shown_ = {};
    map_.reset();
    parts_.clear();
    order_ = {};
    felt_order_ = {};
    servo_->feel(nothing_to_feel(profile_));
    servo_->forget_recording();
}

void Kiosk::step(std::int64_t now_ns) {
    const double now_s = 1e-9 * static_cast<double>(now_ns);
    now_s_ = now_s;
    follow_headphones();
    follow_stick(now_ns);
    follow_loader();
    follow_camera(now_s);
    hand_ = servo_->latest();
    force_ = servo_->force_status();
    if (now_s - ticked_s_ >= tick_s) {
        ticked_s_ = now_s;
        follow_servo();
        follow_troubles();
        apply(Tick{now_s});
        if (settings_.two_switches == SwitchUse::by_itself && !is_operator_in())
            press_switch(SwitchEvent::tick);
        follow_operator();
    }
    sound_->step({hand_, shown_.scene.get(), target()});
}

std::string Kiosk::sound_sign() const {
    if (!sign_ || now_s_ - signed_s_ > sign_s) return {};
    const EventRow& row = screen_rows()[static_cast<std::size_t>(*sign_)];
    return row.cue ? words_of(*row.cue, language()) : std::string();
}

void Kiosk::follow_headphones() {
    const std::optional<bool> are_in = sound_->are_headphones_in();
    if (are_in == std::exchange(are_headphones_in_, are_in)) return;
    follow_rules();
    apply(HeadphonesChanged{are_in.value_or(true)});
}

void Kiosk::offer(std::vector<FilePtr> files, const StickRest& rest) {
    std::vector<std::string> names;
    for (const FilePtr& file : files) names.push_back(file->file_name);
    pictures_.put_stick(std::move(files));
    apply(StickCame{std::move(names), rest});
}

void Kiosk::follow_stick(std::int64_t now_ns) {
    if (!sticks_) return;
    auto change = sticks_->poll(now_ns);
    follow_part(Part::sticks, sticks_->is_watching());
    const bool was_listing = std::exchange(is_listing_, sticks_->is_listing());
    if (change && !change->files.empty()) {
        offer(std::move(change->files), change->rest);
    } else if (change) {
        pictures_.put_stick({});
        apply(StickGone{change->is_read
                            ? nothing_words(change->rest, language())
                            : told_of_file(change->sentence, stick_trouble, language())});
    } else if (is_listing_ && !was_listing) {
        apply(StickArriving{});
    }
}

void Kiosk::follow_loader() {
    for (Delivery& delivery : loader_->poll()) take(std::move(delivery));
    if (const auto things = loader_->take_things()) {
        if (!things->why_not.empty())
            report("a photograph's main thing was not looked for: " + things->why_not);
        apply(ThingsLookedFor{things->request, things->place, things->names});
    }
}

void Kiosk::take(Delivery delivery) {
    if (delivery.request != order_.request || !wanted_) return;
    if (!delivery.scene) return refuse(delivery.request, delivery.scene.error().line);
    if (!std::exchange(is_loading_, false) && !delivery.is_better) return;
    shown_ = delivery.scene->shown;
    map_ = delivery.scene->felt.map;
    felt_file_ = wanted_;
    felt_order_ = order_;
    PictureFacts facts = facts_of(*delivery.scene, *wanted_, order_.form, language());
    parts_ = facts.parts;
    servo_->feel(delivery.scene->felt);
    if (operator_ && !delivery.is_better) operator_->count_picture(order_.source);
    apply(PictureReady{delivery.request, std::move(facts)});
}

/// Removes the file's name, which begins every line about it, tells nothing and may hold anything.
std::string Kiosk::told_reason(const std::string& line) const {
    const std::string& name = wanted_->name;
    return told_of_file(line.starts_with(name) ? line.substr(name.size()) : line, picture_trouble,
                        language());
}

void Kiosk::refuse(std::uint64_t request, const std::string& line) {
    const bool is_answer = line == nothing_there;
    if (!is_answer) report(wanted_->is_private ? "a visitor's picture cannot be felt" : line);
    const std::string sentence =
        order_.thing_at
            ? language().text("trouble", is_answer ? line
                                                   : "The main thing cannot be looked for "
                                                     "now.")
            : told_reason(line);
    stay_with_felt();
    apply(PictureFailed{request, sentence});
}

void Kiosk::follow_camera(double now_s) {
    if (!photos_) return;
    PhotoNews news = photos_->step(now_s);
    const bool has_camera = news.condition != CameraCondition::absent;
    if (has_camera != std::exchange(has_camera_, has_camera)) apply(CameraChanged{has_camera});
    follow_part(Part::camera, has_camera);
    trouble(TroubleKind::camera,
            news.condition == CameraCondition::stopped
                ? language().text("camera", std::string(sentence(news.condition)))
                : "");
    if (news.photo && visit_.visitor.is_capturing) {
        pictures_.put_photo(std::move(news.photo));
        apply(CameraCaptured{news.is_doubtful});
    }
    if (news.has_given_up)
        apply(CameraFailed{language().text("camera", "The camera gave no photo. Try again.")});
}

std::shared_ptr<const Canvas> Kiosk::preview() const {
    return photos_ && is_previewing_ && settings_.is_preview_allowed ? photos_->preview() : nullptr;
}

void Kiosk::follow_servo() {
    HandleSeen seen;
    seen.place_W = hand_.p_WH;
    seen.speed_m_per_s = hand_.speed_m_per_s;
    if (map_) seen.part = part_at(*map_, parts_, hand_);
    seen.has_moved = norm(hand_.p_WH - last_seen_W_) > moved_m;
    if (seen.has_moved) last_seen_W_ = hand_.p_WH;
    const GuidancePhase phase = hand_.guidance.phase;
    seen.is_led = phase == GuidancePhase::running || phase == GuidancePhase::pausing;
    // The operator's hand keeps a visit alive, but begins none.
    if (is_operator_in()) seen.has_moved = is_visit_on(visit_);
    apply(seen);
    follow_guidance();
}

void Kiosk::follow_guidance() {
    const GuidanceStatus& status = hand_.guidance;
    if (!is_guiding_ || status.serial != guidance_.serial) return;
    const bool has_arrived = status.phase == GuidancePhase::arrived;
    if (!has_arrived && status.phase != GuidancePhase::stopped) return;
    is_guiding_ = false;
    apply(GuidanceEnded{has_arrived});
}

/// While the handle is led to a place, cues tell the way.
std::optional<Position> Kiosk::target() const {
    if (!is_guiding_ || guidance_.kind != GuidanceKind::to_place) return std::nullopt;
    return guidance_.place;
}

void Kiosk::follow_troubles() {
    trouble(TroubleKind::device, device_trouble());
    const std::string silence = sound_->problem();
    trouble(TroubleKind::sound, silence);
    follow_part(Part::sound, silence.empty());
}

void Kiosk::follow_part(Part part, bool is_there) {
    const std::string line = missing_.step(part, is_there, now_s_);
    if (!line.empty()) report(line);
}

std::string Kiosk::device_trouble() const {
    if (force_.fault != Fault::none) return spoken_fault(force_.fault, language());
    return told_of_device(servo_->device_words(), language());
}

void Kiosk::trouble(TroubleKind kind, const std::string& sentence) {
    std::string& told = troubles_[static_cast<std::size_t>(kind)];
    if (sentence == told) return;
    told = sentence;
    if (sentence.empty())
        apply(TroubleEnded{kind});
    else
        apply(TroubleBegan{kind, sentence});
}

void Kiosk::report(const std::string& line) {
    const std::string plain = plain_line(line);
    if (operator_) operator_->log(plain);
    report_ += plain + '\n';
}

std::string Kiosk::take_report() {
    const std::string notice = servo_->take_notice();
    if (!notice.empty()) report(notice);
    tell_of_recording(notice);
    return std::exchange(report_, {});
}

void Kiosk::stop() {
    if (sticks_) sticks_->end_session();
    servo_->stop();
}

}  // namespace touchline
