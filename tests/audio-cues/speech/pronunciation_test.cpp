// Tests how the voices say what must be understood at once: letters, digits, keys, places, hours,
// codes, dates and names of files. Somebody has read every line of said/CODE.txt as phonemes; a
// test fails on anything said otherwise and shows the new line. Listen to it before you put it in.
#include "app/documents/sticks/spoken_name.h"
#include "audio-cues/speech/espeak_engine.h"
#include "audio-cues/speech/speech_input.h"
#include "tests/app/documents/gallery/pictures.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <set>

#include <espeak-ng/speak_lib.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

const std::string said_folder = TOUCHLINE_SOURCE_DIR "/tests/audio-cues/speech/said/";
const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
const std::string digits = "0123456789";

/// A language with its voice. The engine keeps this voice until another one is made.
struct Voice {
    Language language;
    std::vector<Respelling> respellings;
};

Voice voice_of(const std::string& code) {
    const auto language = Language::load(TOUCHLINE_CATALOGUES, code);
    EXPECT_TRUE(language) << language.error().line;
    EXPECT_TRUE(EspeakEngine::start(language->voice()));
    return {*language, respellings_of(language->respelling())};
}

/// Returns the phonemes of a text as the kiosk gives it to the voice; " | " separates clauses. The
/// Spanish "rr" of "erre" is R2 since espeak-ng 1.52; before, it was **.
std::string phonemes(const Voice& voice, const std::string& text) {
    const std::string spoken = respelled(text, voice.respellings);
    const void* rest = spoken.c_str();
    std::string all;
    while (rest != nullptr) {
        const char* clause = espeak_TextToPhonemes(&rest, espeakCHARS_UTF8, 0);
        std::string said = clause == nullptr ? "" : clause;
        said.erase(0, said.find_first_not_of(' '));
        if (!said.empty()) all += (all.empty() ? "" : " | ") + said;
    }
    for (auto at = all.find("R2"); at != std::string::npos; at = all.find("R2"))
        all.replace(at, 2, "**");
    return all;
}

/// Reads lines of "text = phonemes".
std::map<std::string, std::string> lines_of(const std::string& code) {
    std::map<std::string, std::string> lines;
    std::ifstream file(said_folder + code + ".txt");
    for (std::string line; std::getline(file, line);) {
        const auto sign = line.find(" = ");
        if (sign != std::string::npos) lines[line.substr(0, sign)] = line.substr(sign + 3);
    }
    return lines;
}

/// Returns the languages whose phonemes somebody has read.
std::vector<std::string> read_codes() {
    std::vector<std::string> codes = languages_in(TOUCHLINE_CATALOGUES).value();
    std::erase_if(codes, [](const std::string& code) { return lines_of(code).empty(); });
    return codes;
}

std::vector<std::string> keys_and_places(const Language& language) {
    std::vector<std::string> texts;
    for (const auto& [key, entry] :
         read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot")) {
        const auto& [context, english] = key;
        const bool is_sentence = english.ends_with('.') || english.find('{') != std::string::npos;
        const bool is_wanted = context == "keys" || context == "place" || context == "thing place";
        if (is_wanted && !is_sentence) texts.push_back(language.text(context, english));
    }
    texts.push_back(language.text("keys", "key number {0}", {"21"}));
    return texts;
}

/// Returns dates with every day and every month once.
std::vector<std::string> dates(const Language& language) {
    std::vector<std::string> texts;
    for (int day = 1; day <= 31; ++day)
        texts.push_back(
            spoken_name(fmt::format("2023{:02}{:02}", (day - 1) % 12 + 1, day), language));
    return texts;
}

std::vector<std::string> codes_and_names(const Language& language) {
    std::vector<std::string> texts{
        "X Y Z A", "1, 0, 9, 6", "21:05", "1:15", "PDF", language.text("visit", "Your USB stick")};
    for (const char* name : {"IMG_2041.jpg", "DSC04512.JPG", "holiday-photo_final(2).png",
                             "XYA.png", "Scan 2024-05-11.pdf", "IMG_20240511_142233.jpg"})
        texts.push_back(spoken_name(name, language));
    for (const int count : {1, 2, 21}) {
        texts.push_back(language.counted("count", "{0} picture", "{0} pictures", count));
        texts.push_back(language.counted("count", "{0} outline", "{0} outlines", count));
        texts.push_back(language.counted("unit", "{0} second", "{0} seconds", count));
    }
    return texts;
}

TEST(Pronunciation, IsAsSomebodyReadIt) {
    for (const std::string& code : read_codes()) {
        const Voice voice = voice_of(code);
        const auto lines = lines_of(code);
        std::vector<std::string> texts;
        for (const char sign : letters + digits) texts.emplace_back(1, sign);
        std::ranges::copy(keys_and_places(voice.language), std::back_inserter(texts));
        std::ranges::copy(codes_and_names(voice.language), std::back_inserter(texts));
        std::ranges::copy(dates(voice.language), std::back_inserter(texts));
        for (const auto& [text, said] : lines) texts.push_back(text);
        for (const std::string& text : std::set<std::string>(texts.begin(), texts.end())) {
            const auto line = lines.find(text);
            const std::string read = line == lines.end() ? "not read yet" : line->second;
            EXPECT_EQ(phonemes(voice, text), read)
                << code << ".txt: " << text << " = " << phonemes(voice, text);
        }
    }
}

TEST(Pronunciation, SomebodyHasReadFiveLanguages) {
    EXPECT_GE(read_codes().size(), 5U);
}

/// Drops marks of stress and joining, separates words at pauses, and makes Spanish b, d, g hard.
std::string plainly(const std::string& phonemes) {
    std::string plain = " ";
    for (std::size_t at = 0; at < phonemes.size(); ++at) {
        const bool is_pause = phonemes.compare(at, 2, "_!") == 0;
        const char c = is_pause ? ' ' : phonemes[at];
        if (std::string_view("',_!|;:-2").find(c) != std::string_view::npos) continue;
        if (c != ' ' || plain.back() != ' ')
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return plain.back() == ' ' ? plain : plain + ' ';
}

/// Returns true if the name is said as a word of its own.
bool is_heard(const std::string& said, const std::string& name) {
    return plainly(said).find(plainly(name)) != std::string::npos;
}

/// Letters next to others, as in a name that is spelled out.
TEST(Pronunciation, ALetterInARowIsTheLetterStill) {
    for (const std::string& code : read_codes()) {
        const Voice voice = voice_of(code);
        const auto lines = lines_of(code);
        for (const char letter : letters) {
            const std::string one(1, letter);
            const std::string name = plainly(lines.at(one));
            const std::string row = plainly(phonemes(voice, one + ' ' + one + " K"));
            EXPECT_TRUE(row.starts_with(name.substr(0, name.size() - 1)) &&
                        row.ends_with(name + plainly(lines.at("K")).substr(1)))
                << code << ": " << one << ": " << row;
        }
    }
}

/// Returns the letters that the English title of a picture names: "The letters A, B and C".
std::string signs_of(const std::string& title) {
    std::string signs;
    for (std::size_t at = title.find("he letters "); at < title.size(); ++at) {
        const bool is_alone =
            !std::isalnum(static_cast<unsigned char>(title[at - 1])) &&
            (at + 1 == title.size() || title[at + 1] == ',' || title[at + 1] == ' ');
        if (is_alone && letters.find(title[at]) != std::string::npos) signs += title[at];
    }
    return signs;
}

TEST(Pronunciation, TheLettersOfTheGalleryAreHeardInEverySentenceAboutThem) {
    const auto english = shipped_pictures();
    for (const std::string& code : read_codes()) {
        const Voice voice = voice_of(code);
        const auto lines = lines_of(code);
        const auto pictures = shipped_pictures({code});
        std::size_t found = 0;
        for (std::size_t i = 0; i < english.size(); ++i) {
            for (const char sign : signs_of(english[i].map.title)) {
                const std::string& name = lines.at(std::string(1, sign));
                for (const std::string& text : {pictures[i].map.title, pictures[i].map.description})
                    EXPECT_TRUE(is_heard(phonemes(voice, text), name))
                        << code << " " << sign << ": " << text << ": " << phonemes(voice, text);
                ++found;
            }
        }
        EXPECT_GE(found, letters.size()) << code;
    }
}

/// "Letter A", "Digit 4": the last sound is the name itself.
TEST(Pronunciation, TheNamesOfPartsEndWithTheirLetterOrDigit) {
    const auto english = shipped_pictures();
    for (const std::string& code : read_codes()) {
        const Voice voice = voice_of(code);
        const auto lines = lines_of(code);
        const auto pictures = shipped_pictures({code});
        std::size_t found = 0;
        for (std::size_t i = 0; i < english.size(); ++i) {
            const auto meant = part_names(english[i].map);
            const auto said = part_names(pictures[i].map);
            for (std::size_t part = 0; part < meant.size(); ++part) {
                if (!meant[part].starts_with("Letter ") && !meant[part].starts_with("Digit "))
                    continue;
                const std::string name =
                    plainly(lines.at(meant[part].substr(meant[part].size() - 1)));
                EXPECT_TRUE(plainly(phonemes(voice, said[part])).ends_with(name))
                    << code << ": " << said[part];
                ++found;
            }
        }
        EXPECT_EQ(found, letters.size() + digits.size()) << code;
    }
}

/// Names of things that stay English in every language.
const std::set<std::string> english_names{
    "Byte",   "CUPS",      "Escape", "Joystick", "Joysticks", "Mark",    "Newton", "ODrive",
    "Office", "Touchline", "WAV",    "input",    "newton",    "newtons", "toml",   "udisks"};

/// Separates words at everything that is not a letter, including hard blanks and typographic signs.
std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words{""};
    for (std::size_t at = 0; at < text.size(); ++at) {
        const auto c = static_cast<unsigned char>(text[at]);
        const bool is_sign = c == 0xE2U || text.compare(at, 2, "\u00a0") == 0;
        if (is_sign) at += c == 0xE2U ? 2 : 1;
        if (!is_sign && (c >= 0x80U || std::isalpha(c))) {
            words.back() += text[at];
        } else {
            words.emplace_back();
        }
    }
    std::erase(words, "");
    return words;
}

bool is_english(const std::string& phonemes) {
    return phonemes.find("(en)") != std::string::npos;
}

/// The voice once read the French "dos" as DOS.
TEST(Pronunciation, NoWordIsTakenForEnglish) {
    const std::string folder = TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/";
    for (const std::string& code : read_codes()) {
        const Voice voice = voice_of(code);
        for (const auto& [key, entry] : read_po(folder + code + ".po")) {
            if (key.second.empty() || key.first == "respelling") continue;
            for (const std::string& text : entry.said) {
                if (!is_english(phonemes(voice, text))) continue;
                for (const std::string& word : words_in(text))
                    EXPECT_TRUE(english_names.contains(word) || !is_english(phonemes(voice, word)))
                        << code << ": " << word << ": " << text;
            }
        }
    }
}

TEST(Pronunciation, ARespellingChangesWhatIsSaid) {
    const Voice english = voice_of("en");
    EXPECT_EQ(phonemes(english, "The letter A is a peak."),
              phonemes(english, "The letter eh is a peak."));
    EXPECT_NE(phonemes(english, "A peak"), phonemes(english, "eh peak"));
    const Voice spanish = voice_of("es");
    EXPECT_EQ(phonemes(spanish, "Letra Y"), phonemes(spanish, "Letra i griega"));
    EXPECT_TRUE(phonemes(spanish, "Y probablemente").starts_with("i "));
    const Voice french = voice_of("fr");
    EXPECT_EQ(phonemes(french, "le dos"), phonemes(french, "le dau"));
    EXPECT_TRUE(is_english(phonemes({french.language, {}}, "le dos")));
    EXPECT_NE(phonemes(french, "signe plus"), phonemes({french.language, {}}, "signe plus"));
}

}  // namespace
}  // namespace touchline
