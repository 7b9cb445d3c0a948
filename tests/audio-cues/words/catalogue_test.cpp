// Tests the rules of audio-cues/words/README.md on every catalogue.
#include "app/visit/status.h"
#include "app/visit/told_lines.h"
#include "app/visit/visit_orders.h"
#include "audio-cues/cues/cue_table.h"
#include "audio-cues/words/language.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string catalogue_folder = TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue";

const PoFile& english() {
    static const PoFile file = read_po(catalogue_folder + "/touchline.pot");
    return file;
}

std::map<std::string, PoFile> translations() {
    std::map<std::string, PoFile> files;
    for (const auto& entry : std::filesystem::directory_iterator(catalogue_folder)) {
        if (entry.path().extension() == ".po") {
            files[entry.path().stem().string()] = read_po(entry.path().string());
        }
    }
    return files;
}

std::vector<std::string> all_codes() {
    return languages_in(TOUCHLINE_CATALOGUES).value();
}

/// Text written only for the voice is not said to anybody.
bool is_said(const std::pair<std::string, std::string>& key) {
    return !key.second.empty() && key.first != "respelling";
}

/// Returns every text that is said, with its language for failure messages.
std::vector<std::pair<std::string, std::string>> all_texts() {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [key, entry] : english()) {
        if (!is_said(key)) continue;
        texts.emplace_back("en", key.second);
        if (!entry.plural.empty()) texts.emplace_back("en", entry.plural);
    }
    for (const auto& [code, file] : translations()) {
        for (const auto& [key, entry] : file) {
            if (!is_said(key)) continue;
            for (const std::string& said : entry.said) texts.emplace_back(code, said);
        }
    }
    return texts;
}

/// Returns the words in lower case (ASCII only), without stops and placeholders.
std::vector<std::string> words_of_sentence(const std::string& sentence) {
    std::vector<std::string> words;
    std::istringstream stream(sentence);
    for (std::string word; stream >> word;) {
        std::string kept;
        for (const char c : word) {
            const bool is_letter = static_cast<unsigned char>(c) >= 0x80U ||
                                   std::isalpha(static_cast<unsigned char>(c));
            if (is_letter) kept += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
        if (!kept.empty()) words.push_back(kept);
    }
    return words;
}

/// A semicolon also separates sentences, as it is heard so.
std::vector<std::string> sentences_of(const std::string& text) {
    std::vector<std::string> sentences{""};
    for (std::size_t i = 0; i < text.size(); ++i) {
        sentences.back() += text[i];
        const bool is_stop = std::string_view(".!?;").find(text[i]) != std::string_view::npos;
        if (is_stop && i + 1 < text.size() && text[i + 1] == ' ') sentences.emplace_back();
    }
    return sentences;
}

std::multiset<std::string> places_of(const std::string& text) {
    std::multiset<std::string> places;
    for (auto at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
        places.insert(text.substr(at, 3));
    }
    return places;
}

std::string with_count(std::string form, int count) {
    for (auto at = form.find("{0}"); at != std::string::npos; at = form.find("{0}"))
        form.replace(at, 3, std::to_string(count));
    return form;
}

TEST(Catalogue, EveryLanguageSaysEveryTextAndNoOther) {
    ASSERT_GT(english().size(), 150U);
    for (const char* code : {"de", "es", "fr", "it"}) ASSERT_TRUE(translations().contains(code));
    for (const auto& [code, file] : translations()) {
        for (const auto& [key, entry] : english()) {
            const auto found = file.find(key);
            ASSERT_NE(found, file.end()) << code << " lacks: " << key.second;
            EXPECT_EQ(found->second.plural, entry.plural) << code << ": " << key.second;
            EXPECT_EQ(found->second.is_doubtful, false) << code << ": " << key.second;
            EXPECT_EQ(found->second.said.size(), entry.plural.empty() ? 1U : plural_forms(file))
                << code << ": " << key.second;
            for (const auto& said : found->second.said) EXPECT_FALSE(said.empty()) << key.second;
        }
        for (const auto& [key, entry] : file) {
            EXPECT_TRUE(english().contains(key))
                << code << " says what English does not: " << key.second;
        }
    }
}

TEST(Catalogue, NoSentenceHasMoreThanTwelveWords) {
    for (const auto& [code, text] : all_texts()) {
        for (const std::string& sentence : sentences_of(text)) {
            EXPECT_LE(words_of_sentence(sentence).size(), 12U) << code << ": " << sentence;
        }
    }
}

TEST(Catalogue, NothingIsSaidOfSeeingOrOfColours) {
    const std::map<std::string, std::set<std::string>> barred{
        {"en",
         {"see", "seen", "look", "looks", "watch", "view", "visible", "red", "blue", "green",
          "yellow", "white", "black", "colour"}},
        {"de",
         {"sehen", "sieht", "siehst", "schauen", "blick", "sichtbar", "rot", "blau", "grün", "gelb",
          "weiß", "schwarz", "farbe"}},
        {"fr",
         {"voir", "voit", "voyez", "regarder", "regardez", "visible", "rouge", "bleu", "vert",
          "jaune", "blanc", "noir", "couleur"}},
        {"es",
         {"ver", "vea", "mirar", "mire", "visible", "rojo", "azul", "verde", "amarillo", "blanco",
          "negro", "color"}},
        {"it",
         {"vedere", "vede", "veda", "vista", "guardare", "guarda", "guardi", "visibile", "rosso",
          "blu", "verde", "giallo", "bianco", "nero", "colore"}}};
    for (const auto& [code, text] : all_texts()) {
        const auto found = barred.find(code);
        if (found == barred.end()) continue;
        for (const std::string& word : words_of_sentence(text)) {
            EXPECT_FALSE(found->second.contains(word)) << code << ": " << text;
        }
    }
    EXPECT_EQ(words_of_sentence("Press it, then see {0}."),
              (std::vector<std::string>{"press", "it", "then", "see"}));
}

/// A singular may say its count as a word, so its {0} may be missing. CountsAreSaid... checks which
/// form is the singular.
std::multiset<std::string> places_but_the_count(const std::string& text) {
    std::multiset<std::string> places = places_of(text);
    places.erase("{0}");
    return places;
}

TEST(Catalogue, PlacesStopsAndBlanksAreAsInEnglish) {
    const auto stop_of = [](const std::string& text) {
        if (text.ends_with("\u2026")) return "...";
        return text.ends_with('.') ? (text.ends_with("...") ? "..." : ".") : "";
    };
    for (const auto& [code, file] : translations()) {
        for (const auto& [key, entry] : file) {
            if (!is_said(key)) continue;
            for (const std::string& said : entry.said) {
                if (entry.plural.empty()) {
                    EXPECT_EQ(places_of(said), places_of(key.second)) << code << ": " << said;
                } else {
                    EXPECT_EQ(places_but_the_count(said), places_but_the_count(entry.plural))
                        << code << ": " << said;
                }
                if (key.first != "decimal") {
                    EXPECT_STREQ(stop_of(said), stop_of(key.second)) << code << ": " << said;
                }
                EXPECT_EQ(said.front() == ' ' || said.back() == ' ', false) << code << ": " << said;
                EXPECT_EQ(said.find("  "), std::string::npos) << code << ": " << said;
            }
        }
    }
}

/// Returns the counts, other than 1, that are not heard. Up to 200, every form of a language
/// occurs.
std::vector<int> unheard_counts(const std::function<std::string(int)>& counted) {
    std::vector<int> unheard;
    for (int count = 0; count <= 200; ++count) {
        const bool is_heard = counted(count).find(std::to_string(count)) != std::string::npos;
        if (count != 1 && !is_heard) unheard.push_back(count);
    }
    return unheard;
}

TEST(Catalogue, CountsAreSaidExceptByTheFormOfOneAlone) {
    const std::vector<int> none;
    for (const std::string& code : all_codes()) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language) << language.error().line;
        for (const auto& [key, entry] : english()) {
            if (entry.plural.empty()) continue;
            const auto counted = [&](int count) {
                return language->counted(key.first, key.second, entry.plural, count);
            };
            EXPECT_EQ(unheard_counts(counted), none) << code << ": " << key.second;
        }
    }
    const auto of_two_forms = [](int count) {  // here zero shares the word for one
        return count < 2 ? std::string("une image") : std::to_string(count) + " images";
    };
    EXPECT_EQ(unheard_counts(of_two_forms), (std::vector<int>{0}));
}

/// If no count uses a form, the header's plural rule is wrong, or there is one form too many.
TEST(Catalogue, EveryFormIsSaidOfSomeCount) {
    for (const auto& [code, file] : translations()) {
        const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
        ASSERT_TRUE(language) << language.error().line;
        for (const auto& [key, entry] : file) {
            if (entry.plural.empty()) continue;
            std::set<std::string> said;
            for (int count = 0; count <= 200; ++count)
                said.insert(language->counted(key.first, key.second, entry.plural, count));
            for (const std::string& form : entry.said) {
                bool is_heard = false;
                for (int count = 0; count <= 200 && !is_heard; ++count)
                    is_heard = said.contains(with_count(form, count));
                EXPECT_TRUE(is_heard) << code << ": " << form;
            }
        }
    }
}

/// Asks the functions that say a text what they say.
TEST(Catalogue, HasAllThatKeysPanelAndFaultsSay) {
    const auto expect = [](const std::string& context, std::string_view text) {
        EXPECT_TRUE(english().contains({context, std::string(text)})) << context << ": " << text;
    };
    for (std::size_t i = 1; i < fault_count; ++i) {
        const FaultWords words = words_of(static_cast<Fault>(i));
        for (const auto text : {words.why, words.visitor_does, words.staff_does})
            expect("fault", text);
    }
    for (const char* text : {"The force is off.", "Then choose: {0}."}) expect("fault", text);
    for (std::size_t i = 0; i < force_state_count; ++i) {
        expect("force", words_of(static_cast<ForceState>(i)));
    }
    for (std::size_t i = 0; i < limit_count; ++i) {
        const auto text = words_of(static_cast<Limit>(i));
        if (!text.empty()) expect("force", text);
    }
    for (int i = 0; i < 4; ++i) expect("mode", words_of(static_cast<Mode>(i)));
    for (int i = 0; i < 3; ++i) expect("contact", words_of(static_cast<ContactState>(i)));
    for (std::size_t i = 0; i < contact_event_count; ++i) {
        expect("event", words_of(static_cast<ContactEventKind>(i)));
    }
    for (const StiffnessStep& step : stiffness_steps) expect("stiffness", step.name);
    for (const CueRow& row : cue_table()) expect("sound", row.name);
}

TEST(Catalogue, HasTheLinesOfThePanel) {
    const Status status = describe(LiveFacts{}, HandState{}, ForceStatus{}, Language());
    for (const StatusLine& line : status.lines) {
        EXPECT_TRUE(english().contains({"panel", line.name})) << line.name;
    }
    EXPECT_TRUE(english().contains({"panel", status.title}));
}

}  // namespace
}  // namespace touchline
