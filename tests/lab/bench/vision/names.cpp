// names_bench NETWORK RESULTS PICTURES LABELS [PICTURES LABELS ...]: measures what vision/name says
// of photographs whose things one reader wrote down before (names_SET.txt). RESULTS/names.csv: with
// its limits moved up and down, by one look and by two; RESULTS/names_said.csv: the words for each
// picture, as shipped.
#include "vision/name/names.h"

#include "app/documents/decode/files.h"
#include "tests/lab/bench/vision/pictures.h"
#include "vision/name/name_network.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace touchline::bench {
namespace {

using Words = std::set<ThingName>;

struct Labels {
    std::string picture;
    Words main;  // what anybody would name first
    Words also;  // also true
};

struct Looked {
    std::vector<Detection> found;
    double ms = 0.0;  // processor time
};

struct Score {
    int own = 0;      // right words that are a thing's own
    int general = 0;  // "an animal", "a vehicle", if right
    int wrong = 0;
    int named = 0;         // pictures whose main thing has a word and was named rightly
    int named_by_own = 0;  // of these, with its own word
    int others_named = 0;  // pictures of another animal or vehicle, named so
};

/// Reads the words between two separators; "-" is none.
Result<Words> words_in(const std::string& text) {
    Words words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream >> std::ws, word, ',');) {
        if (word == "-") continue;
        const auto at = std::ranges::find(thing_ids, word);
        if (at == thing_ids.end()) return failure("\"" + word + "\" is no word of ThingName");
        words.insert(static_cast<ThingName>(at - thing_ids.begin()));
    }
    return words;
}

Result<std::vector<Labels>> labels_in(const std::string& path) {
    std::vector<Labels> all;
    std::ifstream lines(path);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        const auto colon = line.find(':');
        const auto also = std::min(line.find(';'), line.size());
        if (colon == std::string::npos || also < colon) return failure(path + ": " + line);
        const auto main = words_in(line.substr(colon + 1, also - colon - 1));
        const auto others = words_in(also < line.size() ? line.substr(also + 1) : "");
        if (!main) return tl::unexpected(main.error());
        if (!others) return tl::unexpected(others.error());
        all.push_back({line.substr(0, colon), *main, *others});
    }
    if (all.empty()) return failure(path + ": has no labels");
    return all;
}

bool is_general(ThingName name) {
    return name == ThingName::animal || name == ThingName::vehicle;
}

bool has_own_word(const Words& words) {
    return std::ranges::any_of(words, [](ThingName name) { return !is_general(name); });
}

/// "An animal" is true of a dog; "a dog" is not true of "an animal".
bool is_true_of(ThingName word, const Words& words) {
    if (word == ThingName::animal) return std::ranges::any_of(words, is_animal);
    if (word == ThingName::vehicle) return std::ranges::any_of(words, is_vehicle);
    return words.contains(word);
}

/// Returns what is said if every limit of the rule rises by `by`. What detections_of left out does
/// not come back.
Words said_of(const std::vector<Detection>& found, double by) {
    std::vector<Detection> moved = found;
    for (Detection& detection : moved) detection.likelihood -= by;
    Words words;
    for (const NamedThing& thing : names_of(moved)) words.insert(thing.name);
    return words;
}

void count(const Labels& labels, const Words& said, Score& score) {
    bool is_named = false;
    bool is_named_by_own = false;
    for (const ThingName word : said) {
        const bool is_of_main = is_true_of(word, labels.main);
        if (!is_of_main && !is_true_of(word, labels.also)) {
            ++score.wrong;
            continue;
        }
        ++(is_general(word) ? score.general : score.own);
        is_named = is_named || is_of_main;
        is_named_by_own = is_named_by_own || (is_of_main && !is_general(word));
    }
    if (has_own_word(labels.main)) {
        score.named += is_named ? 1 : 0;
        score.named_by_own += is_named_by_own ? 1 : 0;
    } else {
        score.others_named += is_named ? 1 : 0;
    }
}

Result<Looked> look_at(const cv::Mat& picture, NameNetwork& network, bool with_mirror_image) {
    const std::clock_t begin = std::clock();
    auto found = network.detections(picture, with_mirror_image);
    const auto clocks = static_cast<double>(std::clock() - begin);
    return found.map([clocks](std::vector<Detection>& all) {
        return Looked{std::move(all), 1e3 * clocks / static_cast<double>(CLOCKS_PER_SEC)};
    });
}

double median_ms(const std::vector<Looked>& all) {
    std::vector<double> times;
    for (const Looked& looked : all) times.push_back(looked.ms);
    std::ranges::nth_element(times, times.begin() + std::ssize(times) / 2);
    return times[times.size() / 2];
}

/// A set of pictures, looked at once and twice.
struct Set {
    std::string name;
    std::vector<Labels> labels;
    std::array<std::vector<Looked>, 2> looks;
};

std::string rows(const Set& set, std::size_t look) {
    const auto& labels = set.labels;
    const auto& all = set.looks[look];
    const auto nameable =
        std::ranges::count_if(labels, [](const Labels& of) { return has_own_word(of.main); });
    const auto others = std::ranges::count_if(
        labels, [](const Labels& of) { return !of.main.empty() && !has_own_word(of.main); });
    std::string text;
    for (int step = -8; step <= 8; ++step) {
        const double by = 0.025 * step;
        Score score;
        for (std::size_t i = 0; i < labels.size(); ++i)
            count(labels[i], said_of(all[i].found, by), score);
        text +=
            fmt::format("{},{},{:.3f},{},{},{},{},{},{},{},{},{},{:.0f}\n", set.name, look + 1, by,
                        labels.size(), nameable, others, score.own, score.general, score.wrong,
                        score.named, score.named_by_own, score.others_named, median_ms(all));
    }
    return text;
}

std::string ids_of(const Words& words) {
    std::string text;
    for (const ThingName name : words)
        text += fmt::format("{}{}", text.empty() ? "" : " + ", id_of(name));
    return text.empty() ? "-" : text;
}

std::string said_rows(const Set& set) {
    std::string text;
    for (std::size_t i = 0; i < set.labels.size(); ++i) {
        const Labels& labels = set.labels[i];
        const Words said = said_of(set.looks[1][i].found, 0.0);
        Words wrong;
        for (const ThingName word : said) {
            if (!is_true_of(word, labels.main) && !is_true_of(word, labels.also))
                wrong.insert(word);
        }
        text += fmt::format("{},{},{},{},{},{}\n", set.name, labels.picture, ids_of(labels.main),
                            ids_of(labels.also), ids_of(said), ids_of(wrong));
    }
    return text;
}

/// Looks at the pictures in `folder` that have labels in `labels_file`, .../names_SET.txt.
Result<Set> looked_at(const std::string& folder, const std::filesystem::path& labels_file,
                      NameNetwork& network) {
    const auto labels = labels_in(labels_file.string());
    if (!labels) return tl::unexpected(labels.error());
    Set set{labels_file.stem().string(), *labels, {}};
    set.name = set.name.substr(set.name.find('_') + 1);
    for (const Labels& of : set.labels) {
        const auto picture = pixels_of(folder + "/" + of.picture + ".jpg");
        if (!picture) return tl::unexpected(picture.error());
        for (const std::size_t mirror_images : {0U, 1U}) {
            auto looked = look_at(*picture, network, mirror_images == 1);
            if (!looked) return tl::unexpected(looked.error());
            set.looks[mirror_images].push_back(std::move(*looked));
        }
    }
    return set;
}

Result<void> measure(const std::vector<std::string>& arguments) {
    cv::setNumThreads(1);
    const auto bytes = read_file(arguments[0]);
    if (!bytes) return tl::unexpected(bytes.error());
    auto network = NameNetwork::from_onnx(*bytes);
    if (!network) return tl::unexpected(network.error());
    std::ofstream table(arguments[1] + "/names.csv");
    table << "set,looks,higher,pictures,nameable,others,own,general,wrong,named,named_by_own,"
             "others_named,ms\n";
    std::ofstream said(arguments[1] + "/names_said.csv");
    said << "set,picture,main,also,said,wrong\n";
    for (std::size_t i = 2; i + 1 < arguments.size(); i += 2) {
        const auto set = looked_at(arguments[i], arguments[i + 1], *network);
        if (!set) return tl::unexpected(set.error());
        table << rows(*set, 0) << rows(*set, 1);
        said << said_rows(*set);
    }
    return {};
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc < 5 || argc % 2 == 0) {
        std::fputs("usage: names_bench NETWORK RESULTS PICTURES LABELS [PICTURES LABELS ...]\n",
                   stderr);
        return 2;
    }
    const auto done = touchline::bench::measure({argv + 1, argv + argc});
    if (done) return 0;
    std::fprintf(stderr, "%s\n", done.error().line.c_str());
    return 1;
}
