#include "app/sound/spoken_news.h"

#include "app/session/fault_words.h"
#include "app/session/status.h"
#include "audio-cues/speech/speech_text.h"

#include <string_view>

namespace touchline {
namespace {

/// Sentences, as they come.
class Sayings {
  public:
    explicit Sayings(const Language& language) : language_(language) {}

    /// "Mode: wall."
    void add(const char* name, const std::string& value) {
        add(language_.text("panel", name) + ": " + value);
    }

    void add(const std::string& sentence) {
        if (sentence.empty()) return;
        const bool has_stop = sentence.ends_with('.') || sentence.ends_with('!');
        text_ += (text_.empty() ? "" : " ") + sentence + (has_stop ? "" : ".");
    }

    [[nodiscard]] const std::string& text() const { return text_; }

    [[nodiscard]] std::string word(const char* context, std::string_view english) const {
        return language_.text(context, std::string(english));
    }

    [[nodiscard]] const Language& language() const { return language_; }

  private:
    const Language& language_;
    std::string text_;
};

bool is_ready(const SpokenState& before, const SpokenState& now) {
    return before.session.is_loading && !now.session.is_loading && now.session.shown.number > 0 &&
           now.session.shown.number == now.session.picture + 1 &&
           now.session.shown.detail == now.session.detail;
}

bool has_failed(const SpokenState& before, const SpokenState& now) {
    return before.session.is_loading && !now.session.is_loading && !is_ready(before, now);
}

bool is_told_again(const Session& before, const Session& now) {
    return now.is_loading && before.request != now.request;
}

void add_loading(Sayings& said, const Session& before, const Session& now) {
    if (!is_told_again(before, now)) return;
    if (before.detail != now.detail) {
        const auto name = detail_words(now.detail);
        said.add("Detail", said.language().text(
                               "panel", "{0} of {1}, {2}",
                               {std::to_string(now.detail), "5", said.word("detail", name)}));
    }
    const bool is_page = before.picture == now.picture && before.place.page != now.place.page;
    said.add(is_page ? said.language().text("page", "Opening page {0} ...",
                                            {std::to_string(now.place.page)})
                     : said.language().text("panel", "Opening picture {0} ...",
                                            {std::to_string(now.picture + 1)}));
}

/// Nothing of a file that is one page, felt as a whole.
void add_place(Sayings& said, const PagePlace& place) {
    const Language& language = said.language();
    if (place.page_count > 1)
        said.add(language.text("page", "Page {0} of {1}",
                               {std::to_string(place.page), std::to_string(place.page_count)}));
    if (place.view_count <= 1) return;
    said.add(
        place.view == place.view_count
            ? language.text("page", "The whole page")
            : language.text("page", "Picture {0} of {1} on it",
                            {std::to_string(place.view), std::to_string(place.view_count - 1)}));
}

void add_picture(Sayings& said, const SpokenState& before, const SpokenState& now) {
    if (!is_ready(before, now)) return;
    said.add(spoken_title(now.session.shown.title));
    add_place(said, now.session.shown.place);
    said.add(said.language().counted("count", "{0} outline", "{0} outlines",
                                     now.session.shown.outline_count));
}

void add_mode(Sayings& said, const Session& before, const Session& now) {
    if (before.mode == now.mode && before.is_pop_through == now.is_pop_through) return;
    const bool gives_way = now.mode == Mode::wall && now.is_pop_through;
    said.add("Mode", said.word("mode", words_of(now.mode)) +
                         (gives_way ? said.word("mode", ", gives way to a push") : ""));
}

void add_level(Sayings& said, const Session& before, const Session& now) {
    if (before.is_level_automatic == now.is_level_automatic &&
        (now.is_level_automatic || before.fixed_level == now.fixed_level)) {
        return;
    }
    if (now.is_level_automatic) return said.add("Level", said.word("level", "by speed"));
    said.add("Level", said.language().text(
                          "panel", "{0} of {1}, {2}",
                          {std::to_string(now.fixed_level),
                           std::to_string(now.shown.coarsest_level), said.word("level", "fixed")}));
}

void add_choices(Sayings& said, const Session& before, const Session& now) {
    add_mode(said, before, now);
    if (before.stiffness != now.stiffness)
        said.add("Stiffness", said.word("stiffness", stiffness_steps[now.stiffness].name));
    add_level(said, before, now);
    if (before.is_force_wanted != now.is_force_wanted)
        said.add("Force", said.word("force", now.is_force_wanted ? "on" : "off"));
    if (!before.shows_keys && now.shows_keys) said.add(spoken_keys(said.language()));
}

/// In the visitor's language where the catalogue has it; what names a file or a stick is English.
Utterance spoken_message(const std::string& message, const Language& language) {
    std::string translated = language.text("session", message);
    const bool is_english = translated == message;
    return {is_english ? "en" : language.code(), std::move(translated), SpeechPriority::text};
}

void add_lines(std::vector<Utterance>& news, const SpokenState& before, const SpokenState& now,
               const Language& language) {
    const bool is_new = has_failed(before, now) || before.session.message != now.session.message;
    if (is_new && !now.session.message.empty())
        news.push_back(spoken_message(now.session.message, language));
    if (before.device_words != now.device_words && !now.device_words.empty())
        news.push_back({"en", now.device_words, SpeechPriority::text});
}

}  // namespace

std::string spoken_title(const std::string& title) {
    return title.find(' ') == std::string::npos ? speakable_name(title) : title;
}

std::string spoken_fault(Fault fault, const Language& language) {
    if (fault == Fault::none) return {};
    const FaultWords words = words_of(fault);
    std::string text;
    for (const std::string_view part : {words.what, words.why, words.what_to_do})
        text += language.text("fault", std::string(part)) + ' ';
    return text + language.text("fault", "Exploring goes on without force.");
}

std::string spoken_keys(const Language& language) {
    std::string text;
    for (const KeyRow& row : key_table()) {
        text += text.empty() ? "" : " ";
        text += language.text("key name", std::string(row.name)) + ": " +
                language.text("key", std::string(row.words)) + '.';
    }
    return text;
}

std::vector<Utterance> spoken_news(const SpokenState& before, const SpokenState& now,
                                   const Language& language) {
    std::vector<Utterance> news;
    if (before.force.fault != now.force.fault && now.force.fault != Fault::none) {
        news.push_back(
            {language.code(), spoken_fault(now.force.fault, language), SpeechPriority::safety});
    }
    Sayings said(language);
    if (before.force.fault != Fault::none && now.force.fault == Fault::none)
        said.add("Force", said.word("force", words_of(now.force.state)));
    add_choices(said, before.session, now.session);
    add_loading(said, before.session, now.session);
    add_picture(said, before, now);
    if (!said.text().empty()) news.push_back({language.code(), said.text(), SpeechPriority::text});
    add_lines(news, before, now, language);
    return news;
}

std::optional<ScreenEvent> screen_event(const SpokenState& before, const SpokenState& now) {
    if (before.force.fault != now.force.fault && now.force.fault != Fault::none)
        return ScreenEvent::fault;
    if (has_failed(before, now)) return ScreenEvent::picture_failed;
    if (is_ready(before, now)) return ScreenEvent::picture_ready;
    const int last = now.session.picture_count - 1;
    const int from = before.session.picture;
    const int to = now.session.picture;
    const bool is_around = (from == last && to == 0) || (from == 0 && to == last);
    if (last > 1 && is_around && is_told_again(before.session, now.session))
        return ScreenEvent::list_end;
    return std::nullopt;
}

}  // namespace touchline
