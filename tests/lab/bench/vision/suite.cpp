// Measures what of somebody else's drawings reaches the hand. suite_bench FOLDER RESULTS EACH.csv
// takes each NAME.svg below FOLDER that has a NAME.png beside it, painted by another program, and
// writes RESULTS/suite.csv (a row for each chapter, the folders of FOLDER) and a row for each
// drawing.
#include "app/documents/decode/opening.h"
#include "tests/app/drawings/paint.h"
#include "tests/lab/bench/vision/picture_truth.h"
#include "vision/simplify/detail_limits.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/ostream.h>

namespace touchline::bench {
namespace {

namespace fs = std::filesystem;

constexpr double bar = 0.99;

struct Chapter {
    int drawings = 0;  // with something to see, painted alike by both programs
    int whole = 0;     // of these with both shares at the bar
    int refused = 0;
    int otherwise = 0;  // painted differently here than by the other program
    int blank = 0;      // nothing to see
    testing::Counted seen;
    testing::Counted felt;
};

testing::Drawing drawing_at(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    testing::Drawing drawing;
    drawing.file = {std::istreambuf_iterator<char>(in), {}};
    return drawing;
}

std::vector<fs::path> drawings_below(const fs::path& folder) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".svg" &&
            fs::exists(fs::path(entry.path()).replace_extension(".png")))
            out.push_back(entry.path());
    std::ranges::sort(out);
    return out;
}

/// What became of a drawing, as one word, and the shares.
struct Judged {
    std::string became;
    Shares shares;
};

Judged judged(const fs::path& drawing) {
    auto painted = open_page_of(fs::path(drawing).replace_extension(".png").string());
    if (!painted) return {"blank", {}};
    const PictureTruth truth = truth_of(testing::pixels_of(painted->picture));
    if (truth.each.empty()) return {"blank", {}};
    auto view = testing::whole_view_of(drawing_at(drawing), most_detail, 1e9);
    if (!view) return {"refused", {}};
    if (!are_alike(truth, truth_of(testing::pixels_of(view->page.picture)),
                   testing::usual_tolerance_mm))
        return {"otherwise", {}};
    const DetailLimits limits = limits_for(most_detail, view->map.area);
    Shares shares = shares_of(truth, view->map, limits.gap_mm, testing::usual_tolerance_mm);
    if (static_cast<int>(view->map.outlines.size()) >= limits.strokes)
        shares.seen.too_many_mm = std::exchange(shares.seen.wrong_mm, 0.0);
    const bool is_whole = shares.seen.share() >= bar && shares.felt.share() >= bar;
    return {is_whole ? "whole" : "fault", shares};
}

void count(const Judged& one, Chapter& chapter) {
    if (one.became == "blank") ++chapter.blank;
    if (one.became == "refused") ++chapter.refused;
    if (one.became == "otherwise") ++chapter.otherwise;
    if (one.became == "whole") ++chapter.whole;
    if (one.became == "whole" || one.became == "fault") ++chapter.drawings;
    chapter.seen += one.shares.seen;
    chapter.felt += one.shares.felt;
}

int run(const fs::path& folder, const fs::path& results, const fs::path& rows) {
    std::map<std::string, Chapter> chapters;
    std::ofstream each(rows);
    fmt::print(each, "drawing,became,felt_share,seen_share,too_near_mm,too_many_mm\n");
    for (const fs::path& drawing : drawings_below(folder)) {
        const Judged one = judged(drawing);
        const fs::path name = fs::relative(drawing, folder);
        fmt::print(each, "{},{},{:.4f},{:.4f},{:.1f},{:.1f}\n", name.string(), one.became,
                   one.shares.seen.share(), one.shares.felt.share(), one.shares.seen.too_near_mm,
                   one.shares.seen.too_many_mm);
        each.flush();
        count(one, chapters[name.begin()->string()]);
    }
    std::ofstream out(results / "suite.csv");
    fmt::print(out,
               "chapter,drawings,whole,felt_share,seen_share,left_share,refused,otherwise,"
               "blank\n");
    for (const auto& [name, c] : chapters) {
        const double left_mm = c.seen.too_near_mm + c.seen.too_many_mm;
        const double all_mm = c.seen.right_mm + c.seen.wrong_mm + left_mm;
        fmt::print(out, "{},{},{},{:.4f},{:.4f},{:.4f},{},{},{}\n", name, c.drawings, c.whole,
                   c.seen.share(), c.felt.share(), all_mm > 0 ? left_mm / all_mm : 0.0, c.refused,
                   c.otherwise, c.blank);
    }
    return each && out && !chapters.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace touchline::bench

int main(int argc, char** argv) {
    if (argc != 4) {
        fmt::print(stderr, "usage: suite_bench FOLDER RESULTS EACH.csv\n");
        return 2;
    }
    return touchline::bench::run(argv[1], argv[2], argv[3]);
}
