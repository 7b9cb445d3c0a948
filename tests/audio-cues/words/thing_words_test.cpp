#include "audio-cues/words/language.h"
#include "config/types/thing_name.h"
#include "tests/audio-cues/words/po_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

const std::array codes{"en", "de", "es", "fr", "it"};

const Language& language(const std::string& code) {
    static std::map<std::string, Language> loaded;
    if (!loaded.contains(code))
        loaded.emplace(code, Language::load(TOUCHLINE_CATALOGUES, code).value());
    return loaded.at(code);
}

std::vector<ThingName> all_names() {
    std::vector<ThingName> names;
    for (std::uint32_t i = 0; i < thing_name_count; ++i) names.push_back(*thing_name_of(i));
    return names;
}

/// A small box with this middle.
ThingBox box_at(double x, double y) {
    return {x - 0.05, y - 0.05, x + 0.05, y + 0.05};
}

NamedThing thing(ThingName name, const ThingBox& box) {
    return {name, box, 0.9};
}

std::string said(const std::vector<NamedThing>& things, const std::string& code) {
    return words_of(things, language(code));
}

const ThingBox whole{0.0, 0.0, 1.0, 1.0};

/// Returns a box for every place that has a name.
std::vector<ThingBox> all_places() {
    std::vector<ThingBox> boxes{whole};
    for (const double y : {0.1, 0.5, 0.9}) {
        for (const double x : {0.1, 0.3, 0.5, 0.7, 0.9}) boxes.push_back(box_at(x, y));
    }
    return boxes;
}

TEST(ThingWords, ADogAndPeopleInEveryLanguage) {
    const std::vector things{thing(ThingName::dog, box_at(0.3, 0.5)),
                             thing(ThingName::person, box_at(0.9, 0.4)),
                             thing(ThingName::person, box_at(0.85, 0.9))};
    EXPECT_EQ(said(things, "en"),
              "Probably a dog, left of the middle. And probably 2 people, on the right.");
    EXPECT_EQ(
        said(things, "de"),
        "Wahrscheinlich ein Hund, links von der Mitte. Und wahrscheinlich 2 Personen, rechts.");
    EXPECT_EQ(said(things, "fr"),
              "Probablement un chien, à gauche du milieu. Et probablement 2 personnes, à droite.");
    EXPECT_EQ(said(things, "es"),
              "Probablemente un perro, a la izquierda del centro. "
              "Y probablemente 2 personas, a la derecha.");
    EXPECT_EQ(said(things, "it"),
              "Probabilmente un cane, a sinistra del centro. "
              "E probabilmente 2 persone, a destra.");
    EXPECT_EQ(said({}, "en"), "");
}

TEST(ThingWords, ArticlesFollowTheGender) {
    const std::map<std::string, std::vector<std::string>> expected{
        {"de", {"eine Person", "eine Katze", "ein Auto", "eine Sitzbank", "ein Tier"}},
        {"fr", {"une personne", "un chat", "une voiture", "un banc", "un animal"}},
        {"es", {"una persona", "un gato", "un coche", "un banco", "un animal"}},
        {"it", {"una persona", "un gatto", "un’automobile", "una panchina", "un animale"}},
        {"en", {"a person", "a cat", "a car", "a bench", "an animal"}}};
    const std::array names{ThingName::person, ThingName::cat, ThingName::car, ThingName::bench,
                           ThingName::animal};
    for (const auto& [code, words] : expected) {
        for (std::size_t i = 0; i < names.size(); ++i)
            EXPECT_EQ(words_of(names[i], 1, language(code)), words[i]);
    }
}

TEST(ThingWords, ManyAreNotCounted) {
    EXPECT_EQ(words_of(ThingName::sheep, 3, language("en")), "3 sheep");
    EXPECT_EQ(words_of(ThingName::horse, 4, language("fr")), "au moins 4 chevaux");
    EXPECT_EQ(words_of(ThingName::person, 12, language("de")), "4 Personen oder mehr");
    EXPECT_EQ(words_of(ThingName::bird, 7, language("es")), "4 pájaros o más");
    EXPECT_EQ(words_of(ThingName::bird, 7, language("it")), "4 uccelli o più");
}

TEST(ThingWords, SeveralThatReachAcrossHaveNoOtherPlace) {
    const std::vector wide{thing(ThingName::person, box_at(0.1, 0.5)),
                           thing(ThingName::person, box_at(0.9, 0.5))};
    EXPECT_EQ(said(wide, "en"), "Probably 2 people, across the picture.");
    EXPECT_EQ(said({thing(ThingName::bed, {0.1, 0.1, 0.9, 0.9})}, "de"),
              "Wahrscheinlich ein Bett, im größten Teil des Bildes.");
    EXPECT_EQ(said({thing(ThingName::train, {0.1, 0.45, 0.9, 0.55})}, "en"),
              "Probably a train, in the middle.");
}

TEST(ThingWords, OnlyALargeThingIsInMostOfThePicture) {
    const NamedThing high = thing(ThingName::bird, {0.15, 0.0, 0.25, 0.1});
    const NamedThing low = thing(ThingName::bird, {0.64, 0.85, 0.74, 0.95});
    ASSERT_GT(area_of(around(high.box, low.box)), 0.5);
    EXPECT_EQ(said({high, low}, "en"), "Probably 2 birds, in the middle.");
    const NamedThing large = thing(ThingName::bird, {0.15, 0.05, 0.74, 0.95});
    for (const auto& both : {std::vector{high, large}, std::vector{large, high}})
        EXPECT_EQ(said(both, "en"), "Probably 2 birds, in most of the picture.");
}

TEST(ThingWords, PlacesGoFromLeftToRightAndFromTopToBottom) {
    std::set<std::string> different;
    for (const ThingBox& box : all_places()) different.insert(words_of(box, language("en")));
    EXPECT_EQ(different.size(), 16U);
    EXPECT_EQ(words_of(box_at(0.1, 0.1), language("en")), "at the top left");
    EXPECT_EQ(words_of(box_at(0.7, 0.9), language("en")), "at the bottom, right of the middle");
    EXPECT_EQ(words_of(ThingBox{0.99, 0.4, 1.0, 0.6}, language("en")), "on the right");
    EXPECT_EQ(words_of(ThingBox{0.0, 0.4, 0.01, 0.6}, language("en")), "on the left");
}

TEST(ThingWords, EveryNameHasWordsOfItsOwnInEveryLanguage) {
    for (const std::string code : codes) {
        if (code == "en") continue;
        std::set<std::string> different;
        for (const ThingName name : all_names()) {
            const std::string one = words_of(name, 1, language(code));
            const std::string many = words_of(name, 3, language(code));
            EXPECT_NE(one, words_of(name, 1, language("en"))) << code;
            EXPECT_EQ(many.rfind("3 ", 0), 0U) << many;
            EXPECT_TRUE(one.starts_with("un ") || one.starts_with("una ") ||
                        one.starts_with("une ") || one.starts_with("uno ") ||
                        one.starts_with("un’") || one.starts_with("ein ") ||
                        one.starts_with("eine "))
                << one;
            different.insert(one);
            different.insert(many);
        }
        EXPECT_EQ(different.size(), 2 * thing_name_count) << code;
        for (const ThingBox& box : all_places())
            EXPECT_NE(words_of(box, language(code)), words_of(box, language("en"))) << code;
    }
}

/// Returns all sentences with one name, up to the longest ones.
std::vector<std::string> all_sentences(const std::string& code) {
    std::vector<std::string> sentences;
    for (const ThingName name : all_names()) {
        for (const ThingBox& box : all_places()) {
            for (const std::size_t count : {1U, 2U, 5U}) {
                std::vector<NamedThing> things(count, thing(name, box));
                sentences.push_back(said(things, code));
                things.insert(things.begin(), thing(ThingName::umbrella, whole));
                sentences.push_back(said(things, code));
            }
        }
        sentences.push_back(
            said({thing(name, box_at(0.1, 0.5)), thing(name, box_at(0.9, 0.5))}, code));
    }
    return sentences;
}

/// Lowers letters of ASCII and of Latin-1 in UTF-8: "Ä" is 0xC3 0x84, "ä" 0xC3 0xA4.
std::string lowered(std::string word) {
    bool is_latin = false;
    for (char& letter : word) {
        const auto c = static_cast<unsigned char>(letter);
        if (c < 0x80U) letter = static_cast<char>(std::tolower(c));
        if (is_latin && c < 0x9FU && c != 0x97U) letter = static_cast<char>(c + 0x20U);
        is_latin = c == 0xC3U;
    }
    return word;
}

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) {
        std::erase_if(word, [](unsigned char c) { return std::ispunct(c) != 0; });
        words.push_back(lowered(word));
    }
    return words;
}

TEST(ThingWords, EverySentenceIsAGuessOfFifteenWordsAtMost) {
    const std::map<std::string, std::string> guess{{"en", "robably "},
                                                   {"de", "ahrscheinlich "},
                                                   {"es", "robablemente "},
                                                   {"fr", "robablement "},
                                                   {"it", "robabilmente "}};
    for (const std::string code : codes) {
        for (const std::string& text : all_sentences(code)) {
            for (std::size_t from = 0; from < text.size();) {
                const std::size_t stop = std::min(text.find(". ", from), text.size() - 1);
                const std::string sentence = text.substr(from, stop + 1 - from);
                EXPECT_LE(words_in(sentence).size(), 15U) << sentence;
                EXPECT_NE(sentence.find(guess.at(code)), std::string::npos) << sentence;
                EXPECT_EQ(sentence.find('{'), std::string::npos) << sentence;
                from = stop + 2;
            }
        }
    }
}

/// Age, gender, feelings, identity, food, sports gear, ties, small goods: singular and plural.
const std::map<std::string, std::set<std::string>> never_said{
    {"en", {"man",      "men",    "woman",     "women",      "boy",      "boys",      "girl",
            "girls",    "child",  "children",  "baby",       "babies",   "adult",     "old",
            "young",    "lady",   "male",      "female",     "happy",    "sad",       "angry",
            "smiling",  "he",     "she",       "his",        "her",      "banana",    "bananas",
            "apple",    "apples", "sandwich",  "orange",     "oranges",  "broccoli",  "carrot",
            "pizza",    "donut",  "cake",      "cakes",      "hot",      "food",      "frisbee",
            "ski",      "skis",   "snowboard", "ball",       "balls",    "kite",      "bat",
            "glove",    "racket", "surfboard", "skateboard", "tie",      "ties",      "handbag",
            "backpack", "bottle", "cup",       "cups",       "glass",    "fork",      "knife",
            "spoon",    "bowl",   "book",      "books",      "clock",    "vase",      "scissors",
            "teddy",    "phone",  "remote",    "mouse",      "keyboard", "laptop",    "toothbrush",
            "suitcase", "toilet", "sink",      "hydrant",    "toaster",  "microwave", "name"}},
    {"de",
     {"mann",     "männer",    "frau",  "frauen",  "junge",     "mädchen", "kind",     "kinder",
      "baby",     "alt",       "alte",  "jung",    "glücklich", "traurig", "er",       "sie",
      "banane",   "apfel",     "äpfel", "kuchen",  "essen",     "ball",    "bälle",    "ski",
      "krawatte", "krawatten", "tasse", "glas",    "flasche",   "messer",  "gabel",    "buch",
      "bücher",   "uhr",       "vase",  "telefon", "handy",     "koffer",  "rucksack", "toilette"}},
    {"fr",
     {"homme",     "hommes", "femme",     "femmes",   "garçon",     "fille",  "enfant",  "enfants",
      "bébé",      "vieux",  "vieille",   "jeune",    "heureux",    "triste", "il",      "elle",
      "banane",    "pomme",  "gâteau",    "balle",    "ballon",     "ski",    "skis",    "cravate",
      "tasse",     "verre",  "bouteille", "couteau",  "fourchette", "livre",  "horloge", "vase",
      "téléphone", "valise", "sac",       "toilettes"}},
    {"es", {"hombre",  "hombres", "mujer",    "mujeres", "niño",     "niña",    "niños",
            "bebé",    "viejo",   "vieja",    "joven",   "feliz",    "triste",  "él",
            "ella",    "plátano", "manzana",  "pastel",  "pelota",   "balón",   "esquí",
            "corbata", "taza",    "vaso",     "botella", "cuchillo", "tenedor", "libro",
            "reloj",   "jarrón",  "teléfono", "maleta",  "mochila",  "inodoro"}},
    {"it", {"uomo",     "uomini",   "donna",     "donne",     "bambino",  "bambina",   "bambini",
            "neonato",  "vecchio",  "vecchia",   "giovane",   "felice",   "triste",    "lui",
            "lei",      "mela",     "banana",    "torta",     "palla",    "pallone",   "sci",
            "cravatta", "tazza",    "bicchiere", "bottiglia", "coltello", "forchetta", "libro",
            "orologio", "telefono", "valigia",   "zaino",     "bagno"}}};

/// Returns every name of a part, and every name of a page that mentions a face.
std::vector<std::string> face_texts(const std::string& code) {
    const PoFile file = read_po(TOUCHLINE_SOURCE_DIR "/audio-cues/words/catalogue/touchline.pot");
    std::vector<std::string> texts;
    for (const auto& [key, entry] : file) {
        const auto& [context, text] = key;
        const bool is_of_a_face = context == "page" && lowered(text).find("face") != text.npos;
        if (context == "part" || is_of_a_face) texts.push_back(language(code).text(context, text));
    }
    for (const std::string_view id : face_part_ids)
        EXPECT_TRUE(file.contains({"part", std::string(id)})) << id;
    return texts;
}

TEST(ThingWords, WhatMayNeverBeSaidIsInNoSentence) {
    for (const std::string code : codes) {
        const std::set<std::string>& barred = never_said.at(code);
        std::vector<std::string> texts = all_sentences(code);
        std::ranges::copy(face_texts(code), std::back_inserter(texts));
        for (const std::string& text : texts) {
            for (const std::string& word : words_in(text))
                EXPECT_FALSE(barred.contains(word)) << code << ": " << text;
        }
    }
    EXPECT_TRUE(never_said.at("en").contains(words_in("Probably a Banana.").back()));
    EXPECT_TRUE(never_said.at("de").contains(words_in("Wahrscheinlich 2 ÄPFEL.").back()));
    EXPECT_TRUE(never_said.at("es").contains(words_in("Él").back()));
}

RC_GTEST_PROP(ThingWords, EveryNameIsSaidOnceInTheOrderOfTheFirstOfEach, ()) {
    const auto numbers = *rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::inRange<std::uint32_t>(0, thing_name_count));
    std::vector<NamedThing> things;
    std::vector<ThingName> first;
    for (const std::uint32_t number : numbers) {
        things.push_back(thing(*thing_name_of(number), box_at(0.3, 0.5)));
        if (std::ranges::find(first, things.back().name) == first.end())
            first.push_back(things.back().name);
    }
    const std::string text = said(things, "en");
    std::size_t from = 0;
    for (const ThingName name : first) {
        const auto count = std::ranges::count(things, name, &NamedThing::name);
        const std::string words = words_of(name, static_cast<int>(count), language("en"));
        from = text.find("robably " + words + ", left of the middle.", from);
        RC_ASSERT(from != std::string::npos);
        ++from;
    }
    RC_ASSERT(std::ranges::count(text, '.') == static_cast<std::ptrdiff_t>(first.size()));
}

TEST(ThingName, ANumberFromElsewhereIsANameOrNone) {
    for (std::uint32_t number = 0; number < thing_name_count; ++number) {
        ASSERT_TRUE(thing_name_of(number));
        EXPECT_EQ(static_cast<std::uint32_t>(*thing_name_of(number)), number);
    }
    EXPECT_FALSE(thing_name_of(thing_name_count));
    EXPECT_FALSE(thing_name_of(0xFFFFFFFFU));
    EXPECT_TRUE(is_animal(ThingName::giraffe) && is_animal(ThingName::animal));
    EXPECT_FALSE(is_animal(ThingName::person) || is_animal(ThingName::vehicle));
    EXPECT_TRUE(is_vehicle(ThingName::boat) && !is_vehicle(ThingName::bird));
}

}  // namespace
}  // namespace touchline
