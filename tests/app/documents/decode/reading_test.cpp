// Tests pages of text without a text layer with the real reader: how many words it reads right.
#include "app/documents/decode/opening.h"
#include "tests/app/documents/decode/encoders.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace touchline {
namespace {

using Words = std::multiset<std::string>;

/// How a page is printed, scanned or photographed.
struct Look {
    int letters_px = 20;
    const char* font = "DejaVu Sans";
    double turned_deg = 0.0;
    int grey = 255;  // of the paper
    int jpeg_quality = 95;
};

struct Sample {
    WrittenLanguage language;
    std::vector<std::string> lines;
};

const std::vector<Sample> samples{
    {WrittenLanguage::english,
     {"The heart pumps blood through", "the body. Left ventricle and",
      "right atrium are shown below.", "Population in 2021: 83 million",
      "Westport Harbour, North Sea"}},
    {WrittenLanguage::german,
     {"Das Herz pumpt Blut durch den", "Körper. Größe und Länge der",
      "Flüsse über tausend Kilometer", "Bevölkerung 2021: 83 Millionen",
      "München, Köln, Nürnberg"}},
    {WrittenLanguage::french,
     {"Le cœur pompe le sang à travers", "le corps. La forêt est située près",
      "de la frontière où il fait chaud", "Population en 2021: 67 millions",
      "Hôtel de ville, élève français"}},
    {WrittenLanguage::spanish,
     {"El corazón bombea la sangre por", "el cuerpo. La montaña más alta",
      "está en España según el mapa", "Población en 2021: 47 millones",
      "Río Duero, península, niño"}},
    {WrittenLanguage::italian,
     {"Il cuore pompa il sangue verso", "il corpo. La città più antica è",
      "sul fiume, perciò qui più navi", "Popolazione nel 2021: 59 milioni",
      "Università di Forlì, Cefalù"}}};

/// The SVG is rendered at its stated size: the decoder makes the longer side 1600 pixels.
std::string svg_of(const Sample& sample, const Look& look) {
    std::ostringstream svg;
    svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1600 400'>"
        << "<rect width='1600' height='400' fill='rgb(" << look.grey << ',' << look.grey << ','
        << look.grey << ")'/><g font-family='" << look.font << "' font-size='" << look.letters_px
        << "' transform='rotate(" << look.turned_deg << " 400 200)'>";
    double y = 200.0 - 4.8 * look.letters_px;
    for (const std::string& line : sample.lines) {
        y += 1.6 * look.letters_px;
        svg << "<text x='100' y='" << y << "'>" << line << "</text>";
    }
    svg << "</g></svg>";
    return svg.str();
}

Page page_of_text(const Sample& sample, const Look& look) {
    const auto drawn = open_page(encoders::bytes_of(svg_of(sample, look)));
    auto page = open_page(encoders::jpeg(drawn.value().picture, {.quality = look.jpeg_quality}));
    return page.value();
}

Words words_in(const std::string& text) {
    std::istringstream stream(text);
    Words words;
    for (std::string word; stream >> word;) words.insert(word);
    return words;
}

struct Score {
    int written = 0;
    int read = 0;
    int right = 0;

    void add(const Words& truth, const Words& found) {
        written += static_cast<int>(truth.size());
        read += static_cast<int>(found.size());
        Words left = truth;
        for (const std::string& word : found) {
            const auto at = left.find(word);
            if (at == left.end()) continue;
            left.erase(at);
            ++right;
        }
    }

    [[nodiscard]] double share_read() const { return static_cast<double>(right) / written; }

    [[nodiscard]] double share_right() const { return static_cast<double>(right) / read; }
};

std::string all_of(const Sample& sample) {
    std::string text;
    for (const std::string& line : sample.lines) text += line + ' ';
    return text;
}

/// Each language in letters of each size, with the looks in turn.
const std::vector<Look> looks{
    {10, "DejaVu Sans", 0.0, 255, 95},   {12, "DejaVu Serif", 1.0, 220, 80},
    {14, "Nimbus Roman", -2.0, 255, 60}, {18, "Nimbus Sans", 2.0, 190, 60},
    {24, "DejaVu Serif", -3.0, 230, 40}, {30, "DejaVu Sans", 3.0, 255, 40}};

TEST(Reading, MostWordsOfEveryLanguageAndSizeAreRightAndHardlyAnyIsWrong) {
    std::map<std::string, Score> of_languages;
    std::map<int, Score> of_sizes;
    Score all;
    for (const Sample& sample : samples) {
        for (const Look& look : looks) {
            const Page page = page_of_text(sample, look);
            ASSERT_TRUE(needs_reading(page));
            const auto found = read_words(page.picture, {{sample.language}});
            ASSERT_TRUE(found.has_value()) << found.error().line;
            std::string text;
            for (const Label& label : found->labels) text += label.text + ' ';
            const Words truth = words_in(all_of(sample));
            const Words words = words_in(text);
            all.add(truth, words);
            of_languages[std::string(name_of(sample.language))].add(truth, words);
            of_sizes[look.letters_px].add(truth, words);
        }
    }
    std::printf("all: %.3f read, %.3f right\n", all.share_read(), all.share_right());
    EXPECT_GE(all.share_read(), 0.95);
    EXPECT_GE(all.share_right(), 0.95);
    for (const auto& [name, score] : of_languages) {
        std::printf("%s: %.3f read, %.3f right\n", name.c_str(), score.share_read(),
                    score.share_right());
        EXPECT_GE(score.share_read(), 0.92) << name;
        EXPECT_GE(score.share_right(), 0.92) << name;
    }
    for (const auto& [px, score] : of_sizes) {
        std::printf("%d px: %.3f read, %.3f right\n", px, score.share_read(), score.share_right());
        EXPECT_GE(score.share_read(), 0.90) << px;
        EXPECT_GE(score.share_right(), 0.85) << px;
    }
}

/// A diagram: its words stand apart, in and beside shapes, and are masked there.
constexpr auto diagram =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1600 1200'>"
    "<rect width='1600' height='1200' fill='white'/><g font-family='DejaVu Sans' font-size='30'>"
    "<rect x='100' y='100' width='300' height='120' fill='none' stroke='black' stroke-width='4'/>"
    "<text x='130' y='170'>Evaporation</text>"
    "<ellipse cx='900' cy='300' rx='300' ry='150' fill='#ffd' stroke='black' stroke-width='5'/>"
    "<text x='760' y='310'>Condensation of water</text>"
    "<path d='M400 700 C 500 500 900 500 1000 700 S 900 1100 700 1050 S 300 900 400 700Z' "
    "fill='#bdf' stroke='black' stroke-width='8'/><text x='520' y='750'>Lake of Geneva</text>"
    "<circle cx='1300' cy='900' r='200' fill='#044'/>"
    "<text x='1210' y='910' fill='white'>Mercury</text></g></svg>";

TEST(Reading, LabelsOfADiagramStandAtTheirPlaces) {
    const auto drawn = open_page(encoders::bytes_of(diagram));
    ASSERT_TRUE(drawn.has_value());
    Page page;  // like a scan: it has no words of its own
    page.picture = drawn->picture;
    page.told.area = drawn->told.area;
    const auto found = read_words(page.picture);
    ASSERT_TRUE(found.has_value()) << found.error().line;
    const Page whole = with_words(page, *found);
    EXPECT_EQ(whole.words.size(), 8U);
    std::map<std::string, Position> places_px;
    const double m_per_px = whole.told.area.width_m / 1600.0;
    for (const Label& label : whole.told.labels)
        places_px[label.text] = {800 + label.place.x / m_per_px, 600 - label.place.y / m_per_px};
    EXPECT_EQ(places_px.size(), 4U);
    for (const auto& [text, middle_px] : {std::pair{"Evaporation", Position{220, 162}},
                                          {"Condensation of water", Position{930, 299}},
                                          {"Lake of Geneva", Position{636, 739}},
                                          {"Mercury", Position{1271, 902}}}) {
        ASSERT_TRUE(places_px.contains(text)) << text;
        EXPECT_NEAR(places_px[text].x, middle_px.x, 12) << text;
        EXPECT_NEAR(places_px[text].y, middle_px.y, 12) << text;
    }
}

class WithoutData : public testing::Test {
  protected:
    /// The folder must exist: since 5.4, tesseract uses its own folder instead of a missing one.
    WithoutData() { setenv("TESSDATA_PREFIX", "/usr/share/fonts", 1); }

    ~WithoutData() override { unsetenv("TESSDATA_PREFIX"); }
};

TEST_F(WithoutData, OneSentenceNamesTheLanguageAndThePackage) {
    const auto found = read_words(encoders::test_picture(), {{WrittenLanguage::german}});
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(
        found.error().line,
        "words in pictures cannot be read in German: its data are missing; install the package "
        "tesseract-ocr-deu");
}

TEST(Reading, WithoutTheProgramItSaysSo) {
    const std::string programs = std::getenv("TOUCHLINE_PROGRAMS");
    setenv("TOUCHLINE_PROGRAMS", "/nowhere", 1);
    const auto found = read_words(encoders::test_picture());
    setenv("TOUCHLINE_PROGRAMS", programs.c_str(), 1);
    ASSERT_FALSE(found.has_value());
    EXPECT_NE(found.error().line.find("installed anew"), std::string::npos);
}

}  // namespace
}  // namespace touchline
