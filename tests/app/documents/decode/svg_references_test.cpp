// Tests how often parts of a drawing are drawn again, against a count by drawing.

#include "app/documents/decode/svg_survey.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline::decode {
namespace {

std::size_t again(const std::string& inside) {
    return drawn_again("<svg>" + inside + "</svg>");
}

TEST(SvgReferences, NothingIsDrawnAgainInAPlainDrawing) {
    EXPECT_EQ(again(R"(<g id="a"><path id="b" fill="red" d="M0 0h9"/></g>)"), 0U);
    EXPECT_EQ(again(R"(<use href="nowhere.svg"/><use href="#nobody"/>)"), 0U);
    EXPECT_EQ(drawn_again("no XML <"), 0U);
    EXPECT_EQ(drawn_again(""), 0U);
}

TEST(SvgReferences, EveryWayToReferCounts) {
    const std::string two = R"(<g id="two"><path/></g>)";
    EXPECT_EQ(again(two + R"(<use href="#two"/>)"), 2U);
    EXPECT_EQ(again(two + R"(<use xlink:href="#two"/>)"), 2U);
    EXPECT_EQ(again(two + R"svg(<path fill="url(#two)"/>)svg"), 2U);
    EXPECT_EQ(again(two + R"svg(<path style="mask: url('#two')"/>)svg"), 2U);
    for (const char* name :
         {"stroke", "clip-path", "filter", "marker", "marker-start", "marker-mid", "marker-end"})
        EXPECT_EQ(again(fmt::format(R"svg({}<path {}="url(#two) none"/>)svg", two, name)), 2U)
            << name;
}

TEST(SvgReferences, ACircleEnds) {
    EXPECT_LE(again(R"(<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>)"), 20U);
    EXPECT_LE(again(R"(<g id="a"><use href="#a"/></g>)"), 20U);
}

TEST(SvgReferences, ALongChainIsTooMuch) {
    std::string nested;
    for (int i = 0; i < 100'000; ++i) nested += "<g>";
    for (int i = 0; i < 100'000; ++i) nested += "</g>";
    EXPECT_GT(again(nested), most_drawn_again);
}

struct Group {
    std::size_t in_all = 2;  // the group and its path
    std::size_t again = 0;
};

/// Groups, each with a path and with uses of earlier groups.
RC_GTEST_PROP(SvgReferences, CountsWhatDrawingWouldDraw, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 12);
    std::vector<Group> groups(count);
    std::string svg;
    std::size_t expected = 0;
    for (std::size_t i = 0; i < count; ++i) {
        svg += fmt::format(R"(<g id="g{}"><path/>)", i);
        const auto most = static_cast<std::size_t>(i == 0 ? 0 : 4);
        const auto uses =
            *rc::gen::resize(static_cast<int>(most),
                             rc::gen::container<std::vector<std::size_t>>(
                                 rc::gen::inRange<std::size_t>(0, std::max<std::size_t>(i, 1))));
        for (std::size_t n = 0; n < std::min(uses.size(), most); ++n) {
            const Group& used = groups[uses[n]];
            svg += fmt::format(R"(<use href="#g{}"/>)", uses[n]);
            groups[i].in_all += 1 + used.in_all;
            groups[i].again += used.in_all;
        }
        svg += "</g>";
        expected += groups[i].again;
    }
    RC_ASSERT(again(svg) == std::min(expected, most_drawn_again + 1));
}

}  // namespace
}  // namespace touchline::decode
