// Tests that what is painted is what is felt, on random drawings from the file to the map.
// TOUCHLINE_EXHAUSTIVE=1 makes more than 300 (tests/README.md).
#include "tests/app/drawings/charts.h"
#include "tests/app/drawings/felt.h"
#include "tests/app/drawings/pdf_drawings.h"
#include "tests/app/drawings/svg_drawings.h"
#include "vision/simplify/detail_limits.h"

#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace touchline {
namespace {

constexpr double least_share_of_drawing = 0.99;  // for one drawing: less is reported
constexpr double least_of_one = 0.95;            // the least measured was 0.974
constexpr double least_of_kind = 0.97;           // for all of one kind
constexpr double least_of_all = 0.995;           // the least measured was 0.9988
constexpr double most_felt = 1.06;               // a line is felt once; the most measured was 1.045

/// Adds up the results of all drawings of some kinds, and names each one below the bar.
class Tally {
  public:
    void add(const testing::Drawing& drawing) {
        const auto found = testing::felt_of(drawing, most_detail, testing::usual_tolerance_mm);
        EXPECT_TRUE(found.has_value()) << drawing.name << ": " << found.error().line;
        if (!found) return;
        of_kind_[drawing.kind] += {found->seen, found->felt};
        judge_one(drawing, *found);
    }

    void judge() const {
        Both all;
        for (const auto& [kind, both] : of_kind_) {
            EXPECT_GE(both.seen.share(), least_of_kind) << kind;
            EXPECT_GE(both.felt.share(), least_of_kind) << kind;
            all += both;
        }
        fmt::print(
            "{:.2f} % of what is seen is felt ({:.1f} m; besides {:.1f} m too near others, "
            "{:.2f} m too short), {:.2f} % of what is felt is seen\n",
            100.0 * all.seen.share(), 1e-3 * all.seen.right_mm, 1e-3 * all.seen.too_near_mm,
            1e-3 * all.seen.too_short_mm, 100.0 * all.felt.share());
        EXPECT_GE(all.seen.share(), least_of_all);
        EXPECT_GE(all.felt.share(), least_of_all);
    }

  private:
    struct Both {
        testing::Counted seen;
        testing::Counted felt;

        Both& operator+=(const Both& other) {
            seen += other.seen;
            felt += other.felt;
            return *this;
        }
    };

    static void judge_one(const testing::Drawing& drawing, const testing::Felt& found) {
        EXPECT_GE(found.seen.share(), least_of_one) << drawing.name;
        EXPECT_GE(found.felt.share(), least_of_one) << drawing.name;
        EXPECT_TRUE(!drawing.unjudged.empty() || found.felt_mm <= most_felt * found.seen_mm)
            << drawing.name << ": " << found.felt_mm << " mm are felt of " << found.seen_mm;
        if (found.seen.share() >= least_share_of_drawing &&
            found.felt.share() >= least_share_of_drawing)
            return;
        fmt::print("{}: {:.1f} % of what is seen is felt, {:.1f} % of what is felt is seen\n",
                   drawing.name, 100.0 * found.seen.share(), 100.0 * found.felt.share());
    }

    std::map<std::string, Both> of_kind_;
};

int seeds(int everyday, int exhaustive) {
    return std::getenv("TOUCHLINE_EXHAUSTIVE") != nullptr ? exhaustive : everyday;
}

TEST(Drawings, AnSvgIsFeltAsItIsPainted) {
    Tally tally;
    for (int feature = 0; feature < testing::svg_feature_count(); ++feature)
        for (int seed = 0; seed < seeds(2, 12); ++seed)
            tally.add(testing::svg_drawing(feature, seed));
    tally.judge();
}

TEST(Drawings, ChartsAndPlansAreFeltAsTheyArePainted) {
    Tally tally;
    for (int kind = 0; kind < testing::chart_kind_count(); ++kind)
        for (int seed = 0; seed < seeds(3, 30); ++seed)
            tally.add(testing::chart_drawing(kind, seed));
    tally.judge();
}

/// Most lines of the grid show only in short pieces between the bars.
TEST(Drawings, AGridBetweenHighBarsIsNotFelt) {
    Tally tally;
    for (const int seed : {17, 28}) tally.add(testing::chart_drawing(0, seed));
    tally.judge();
}

TEST(Drawings, PagesOfPdfAreFeltAsTheyArePainted) {
    Tally tally;
    for (int page = 0; page < seeds(2, 28) * testing::pdf_page_count(); ++page)
        tally.add(testing::pdf_page(page));
    tally.judge();
}

TEST(Drawings, TheSameAsPdfIsFeltAsItIsPainted) {
    Tally tally;
    for (int seed = 0; seed < seeds(1, 6); ++seed) {
        for (int feature = 0; feature < testing::svg_feature_count(); ++feature)
            tally.add(testing::as_pdf(testing::svg_drawing(feature, seed), seed));
        for (int kind = 0; kind < testing::chart_kind_count(); ++kind)
            tally.add(testing::as_pdf(testing::chart_drawing(kind, seed), seed));
    }
    tally.judge();
}

}  // namespace
}  // namespace touchline
