#include "app/kiosk/kiosk.h"

#include "app/documents/sticks/spoken_name.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/visit/told_lines.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <utility>

namespace touchline {
namespace {

constexpr double tick_s = 0.05;  // the visit's tick
constexpr double sign_s = 1.0;   // how long the sign of a sound stays

/// The index of the language with this code; 0 if there is none.
std::size_t place_of(const std::string& code, const std::vector<Language>& languages) {
    const auto at = std::ranges::find_if(
        languages, [&code](const Language& language) { return language.code() == code; });
    return at == languages.end() ? 0 : static_cast<std::size_t>(at - languages.begin());
}

std::vector<std::string> names_of(const std::vector<FilePtr>& files) {
    std::vector<std::string> names;
    for (const FilePtr& file : files) names.push_back(file->file_name);
    return names;
}

}  // namespace

/// Carries out each order of a visit.
struct Kiosk::VisitOrderHandler {
    Kiosk& kiosk;

    /// The visit is silent while the operator is in.
    void operator()(const Utterance& utterance) const {
        if (kiosk.is_operator_in() && utterance.priority != SpeechPriority::safety) return;
        kiosk.key_caption_.clear();
        kiosk.say(utterance);
    }

    void operator()(const Hush&) const { kiosk.sound_->hush(); }

    void operator()(const HoldSpeech&) const { kiosk.sound_->toggle_pause(); }

    void operator()(const GiveCue& cue) const {
        if (kiosk.is_operator_in()) return;
        kiosk.sound_->give(cue.event);
        kiosk.sign_ = {cue.event, kiosk.now_s_};
    }

    void operator()(const GivePattern& pattern) const {
        if (!kiosk.is_operator_in()) kiosk.handle_.carry_out(pattern);
    }

    void operator()(const LoadPicture& order) const {
        kiosk.tell(kiosk.picture_.want(order, kiosk.visit_.visitor, kiosk.pictures_.of(order),
                                       kiosk.language()));
    }

    void operator()(const FeelDrawing& order) const { kiosk.feel_drawing(order); }

    void operator()(const CancelLoad&) const { kiosk.picture_.cancel(); }

    void operator()(const Feel& feel) const { kiosk.handle_.carry_out(feel); }

    void operator()(const Guide& guide) const { kiosk.handle_.carry_out(guide); }

    void operator()(const CameraPreview& preview) const {
        if (kiosk.photos_) kiosk.photos_->show(preview.is_on);
    }

    void operator()(const Capture&) const {
        if (kiosk.photos_) kiosk.photos_->take();
    }

    void operator()(const PrintSheet&) const {
        if (kiosk.printer_ && kiosk.picture_.map() != nullptr)
            kiosk.printer_->print(
                kiosk.map_to_print(),
                {kiosk.settings_.printer, kiosk.settings_.sheet, kiosk.language().code()});
    }

    void operator()(const GiveStickBack&) const {
        if (kiosk.sticks_) kiosk.sticks_->end_session();
    }

    void operator()(const Wipe&) const { kiosk.wipe(); }

    void operator()(const SoundWanted& wanted) const { kiosk.sound_->choose(wanted); }

    void operator()(const LookWanted&) const {}  // the screen asks the visit

    void operator()(const CallStaff&) const {}  // the same

    void operator()(const Quit&) const { kiosk.window_wishes_.is_quitting = true; }
};

Kiosk::Kiosk(KioskParts parts)
    : languages_(std::move(parts.languages)),
      settings_(std::move(parts.settings)),
      pictures_(std::move(parts.gallery)),
      profile_(parts.profile),
      handle_(std::move(parts.servo), parts.profile, settings_),
      sound_(std::move(parts.sound)),
      braille_(parts.braille ? std::move(parts.braille) : std::make_unique<NoBraille>()),
      picture_(std::move(parts.loader)),
      sticks_(std::move(parts.sticks)),
      photos_(std::move(parts.photos)),
      printer_(std::move(parts.printer)),
      operator_(std::move(parts.operator_session)),
      keys_{std::move(parts.keys),
            KeyFilter(settings_.double_strike_s),
            {},
            0.0,
            parts.are_keys_free},
      hours_(std::move(parts.minute_of_day)),
      today_(std::move(parts.today)),
      reading_language_(std::move(parts.reading_language)) {
    device_facts_.hand_words = std::move(parts.hand_words);
    device_facts_.hand_name = std::move(parts.hand_name);
    follow_rules();
    rules_.has_camera = photos_ != nullptr;
    rules_.has_stick_port = sticks_ != nullptr;
    take(start_visit(world()));
}

void Kiosk::apply(const VisitEvent& event) {
    take(touchline::step(visit_, event, world()));
}

void Kiosk::tell(const std::optional<VisitEvent>& event) {
    if (event) apply(*event);
}

void Kiosk::take(VisitStep step) {
    const VisitScreen before = open_screen(visit_);
    visit_ = std::move(step.visit);
    forget_words_between_visits(before);
    for (const VisitOrder& order : step.orders) std::visit(VisitOrderHandler{*this}, order);
    if (reading_language_) *reading_language_ = written_language(language().code());
}

void Kiosk::set(const Settings& settings) {
    if (settings.double_strike_s != settings_.double_strike_s)
        keys_.filter = KeyFilter(settings.double_strike_s);
    const Settings before = std::exchange(settings_, settings);
    follow_rules();
    apply(SettingsChanged{before});
    handle_.set_servo();
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
    rules_.inactivity_s = settings_.inactivity_s;
    rules_.answer_s = settings_.answer_s;
    rules_.offers_staff = settings_.offers_staff;
    rules_.notice = settings_.notice;
    braille_->choose(settings_.braille);
    rules_.has_printer = printer_ && !settings_.printer.empty();
    if (sticks_)
        sticks_->allow(settings_.more_file_systems ? FileSystems::more : FileSystems::usual);
    if (photos_)
        photos_->set({settings_.cut_left_percent, settings_.cut_right_percent,
                      settings_.cut_top_percent, settings_.cut_bottom_percent});
}

void Kiosk::wipe() {
    picture_.forget();
    pictures_.forget();
    if (photos_) photos_->forget();
    sound_->forget();
    braille_->forget();
    handle_.wipe();
}

void Kiosk::step(std::int64_t now_ns) {
    now_s_ = 1e-9 * static_cast<double>(now_ns);
    if (!started_s_) started_s_ = now_s_;
    handle_.set_time(now_s_);
    handle_.set_nobody_here(is_nobody_here());
    follow_headphones();
    follow_stick(now_ns);
    follow_loader();
    follow_camera();
    follow_pen();
    handle_.look();
    follow_braille();
    if (now_s_ - ticked_s_ >= tick_s) tick();
    sound_->step({hand(), shown().scene.get(), handle_.target(), is_nobody_here()});
}

void Kiosk::tick() {
    ticked_s_ = now_s_;
    rules_.is_operator_in = is_operator_in();
    follow_handle();
    follow_troubles();
    apply(Tick{now_s_});
    scan_by_itself();
    count_visit();
    follow_hours();
    follow_printer();
    follow_operator();
}

std::string Kiosk::sound_sign() const {
    if (!sign_ || now_s_ - sign_->since_s > sign_s) return {};
    const EventRow& row = screen_rows()[static_cast<std::size_t>(sign_->event)];
    return row.cue ? words_of(*row.cue, language()) : std::string();
}

void Kiosk::follow_headphones() {
    const auto change = watched_.headphones(sound_->are_headphones_in());
    if (!change) return;
    follow_rules();
    apply(*change);
}

void Kiosk::give(std::vector<FilePtr> files) {
    std::vector<std::string> names = names_of(files);
    pictures_.give(std::move(files));
    apply(PicturesGiven{std::move(names)});
}

void Kiosk::offer(std::vector<FilePtr> files, const StickRest& rest) {
    std::vector<std::string> names = names_of(files);
    pictures_.put_stick(std::move(files));
    apply(StickCame{std::move(names), rest});
}

void Kiosk::follow_stick(std::int64_t now_ns) {
    if (!sticks_) return;
    auto change = sticks_->poll(now_ns);
    follow_part(Part::sticks, sticks_->is_watching());
    const auto arriving = watched_.listing(sticks_->is_listing());
    if (!change) return tell(arriving);
    if (!change->files.empty()) return offer(std::move(change->files), change->rest);
    pictures_.put_stick({});
    apply(StickGone{change->is_read ? nothing_words(change->rest, language())
                                    : told_of_file(change->sentence, stick_trouble, language())});
}

void Kiosk::follow_loader() {
    for (const Delivery& delivery : picture_.poll()) {
        const auto news = picture_.take(delivery, language());
        if (!news) continue;
        if (!news->line.empty()) report(news->line);
        if (news->felt) handle_.servo().feel(*news->felt);
        if (news->felt && operator_ && !news->is_better)
            operator_->count_picture(picture_.order().source, today());
        apply(news->event);
        keep_lines_of_felt();
    }
    if (const auto things = picture_.take_things()) {
        if (!things->why_not.empty())
            report("a photograph's main thing was not looked for: " + things->why_not);
        apply(ThingsLookedFor{things->request, things->place, things->names});
    }
}

void Kiosk::feel_drawing(const FeelDrawing& order) {
    const auto drawing = scene_of_drawing(order.map, profile_);
    if (!drawing) return report("a drawing cannot be felt: " + drawing.error().line);
    handle_.servo().feel(drawing->felt);
    apply(PictureReady{order.request, picture_.put_drawing(order.request, *drawing, language())});
}

bool Kiosk::takes_pen() const {
    return touchline::takes_pen(visit_) && !visit_.visitor.look.is_off && !is_operator_in();
}

void Kiosk::change_pen(const PenChange& change) {
    if (!takes_pen()) return;
    tell(pen_.step(change, visit_.visitor.drawing->area()));
}

/// Somebody left the drawing while another one drew.
void Kiosk::follow_pen() {
    if (takes_pen() || !pen_.is_down()) return;
    pen_.drop();
    apply(StrokeLost{});
}

/// The first page of a picture stands for it in its list.
void Kiosk::keep_lines_of_felt() {
    const auto& felt = visit_.visitor.felt;
    if (!felt || felt->order.request != picture_.order().request) return;
    const LoadPicture& order = felt->order;
    const bool is_of_list =
        order.source == PictureSource::gallery || order.source == PictureSource::stick;
    if (is_of_list && order.page == 1 && order.zoom.factor <= 1.0)
        pictures_.keep_lines(order.source, felt->facts.title, *picture_.map());
}

void Kiosk::follow_camera() {
    if (!photos_) return;
    PhotoNews news = photos_->step(now_s_);
    const bool is_there = news.condition != CameraCondition::absent;
    tell(watched_.camera(is_there));
    follow_part(Part::camera, is_there);
    tell(watched_.trouble(TroubleKind::camera,
                          news.condition == CameraCondition::stopped
                              ? language().text("camera", std::string(sentence(news.condition)))
                              : ""));
    if (news.photo && visit_.visitor.is_capturing) {
        pictures_.put_photo(std::move(news.photo));
        apply(CameraCaptured{news.is_doubtful});
    }
    if (news.has_given_up)
        apply(CameraFailed{language().text("camera", "The camera gave no photo. Try again.")});
}

void Kiosk::follow_printer() {
    if (!printer_) return;
    const auto end = printer_->step(settings_.printer, now_s_, is_operator_in());
    if (!end) return;
    if (*end != PrintEnd::printed) report("print: " + std::string(line_of(*end)));
    apply(SheetEnded{*end});
}

/// What is felt, called as it is called here.
TactileMap Kiosk::map_to_print() const {
    TactileMap map = *picture_.map();
    if (const auto& felt = visit_.visitor.felt) {
        if (map.title.empty()) map.title = felt->facts.title;
        if (map.description.empty()) map.description = felt->facts.description;
    }
    return map;
}

std::shared_ptr<const Canvas> Kiosk::preview() const {
    return photos_ && settings_.is_preview_allowed ? photos_->preview() : nullptr;
}

DrawnPicture Kiosk::drawn() const {
    const AttractPicture& attract = pictures_.attract();
    if (!is_nobody_here() || !attract.shown.scene) return {shown(), hand()};
    return {attract.shown, attract_hand(attract, now_s_)};
}

std::vector<LineDrawingPtr> Kiosk::pictures_of(const SpokenScreen& screen) const {
    const bool is_stick = open_screen(visit_) == VisitScreen::stick;
    const bool is_list = is_stick || open_screen(visit_) == VisitScreen::gallery;
    if (is_operator_in() || !is_list) return {};
    const PictureSource source = is_stick ? PictureSource::stick : PictureSource::gallery;
    std::vector<LineDrawingPtr> pictures;
    for (const ScreenItem& item : screen.items)
        pictures.push_back(pictures_.lines_of(source, item.name, visit_.visitor.sound.language));
    const bool is_any =
        std::ranges::any_of(pictures, [](const LineDrawingPtr& each) { return each != nullptr; });
    return is_any ? pictures : std::vector<LineDrawingPtr>();
}

void Kiosk::follow_handle() {
    HandleSeen seen = handle_.take_seen();
    seen.part = picture_.part_at(hand());
    // The operator's hand keeps a visit alive, but begins none.
    if (is_operator_in()) seen.has_moved = is_visit_on(visit_);
    apply(seen);
    tell(handle_.take_guidance_end());
}

void Kiosk::follow_troubles() {
    tell(watched_.trouble(TroubleKind::device, device_trouble()));
    const std::string silence = sound_->problem();
    tell(watched_.trouble(TroubleKind::sound, silence));
    follow_part(Part::sound, silence.empty());
}

void Kiosk::follow_part(Part part, bool is_there) {
    const std::string line = missing_.step(part, is_there, now_s_);
    if (!line.empty()) report(line);
}

std::string Kiosk::device_trouble() const {
    if (force().fault != Fault::none) return spoken_fault(force().fault, language());
    return told_of_device(handle_.servo().device_words(), language());
}

void Kiosk::report(const std::string& line) {
    const std::string plain = plain_line(line);
    if (operator_) operator_->log(plain);
    report_ += plain + '\n';
}

LiveFacts Kiosk::live_facts() const {
    LiveFacts facts = device_facts_;
    facts.last = sound_->last_event();
    facts.has_pop_through = settings_.has_pop_through;
    facts.message = told_of_device(handle_.servo().device_words(), language(), ToldTo::staff);
    const TactileMap* const map = picture_.map();
    if (map == nullptr) return facts;
    facts.title = map->title;
    if (const auto& felt = visit_.visitor.felt) {
        facts.place = felt->facts.place;
        facts.title = felt->facts.title;
    }
    facts.detail = picture_.order().detail;
    if (shown().scene) facts.coarsest_level = shown().scene->curves.coarsest();
    return facts;
}

std::string Kiosk::take_report() {
    const std::string notice = handle_.servo().take_notice();
    if (!notice.empty()) report(notice);
    tell_of_recording(notice);
    return std::exchange(report_, {});
}

void Kiosk::stop() {
    if (sticks_) sticks_->end_session();
    handle_.servo().stop();
}

}  // namespace touchline
