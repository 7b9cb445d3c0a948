// Tests answers of a worker that traced a picture.
#include "app/documents/trace/traced.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

using Bytes = std::vector<std::byte>;

TracedMap felt() {
    TracedMap traced;
    traced.map.outlines = {{{{0.0, 0.0}, {0.01, 0.02}, {0.0, 0.01}}, true, "outline-1", "a shape"}};
    traced.warning = "Expect little.";
    traced.report = "{\n  \"outlines\": 1\n}\n";
    traced.edges = {2, 3, {0, 1, 2, 253, 254, 255}};
    return traced;
}

const Bytes line_bytes(100, std::byte{7});

std::string why_refused(const Bytes& bytes) {
    const auto traced = traced_of(bytes);
    EXPECT_FALSE(traced.has_value());
    return traced ? "" : traced.error().line;
}

TEST(Traced, CrossesWhole) {
    const Bytes bytes = bytes_of(felt(), line_bytes).value();
    const auto traced = traced_of(bytes);
    ASSERT_TRUE(traced.has_value()) << traced.error().line;
    EXPECT_TRUE(traced->has_lines);
    ASSERT_TRUE(traced->map.has_value());
    ASSERT_EQ(traced->map->map.outlines.size(), 1U);
    EXPECT_EQ(traced->map->map.outlines[0].label, "a shape");
    EXPECT_EQ(traced->map->map.outlines[0].points, felt().map.outlines[0].points);
    EXPECT_EQ(traced->map->warning, felt().warning);
    EXPECT_EQ(traced->map->report, felt().report);
    EXPECT_EQ(traced->map->edges.width, 2);
    EXPECT_EQ(traced->map->edges.height, 3);
    EXPECT_EQ(traced->map->edges.grey, felt().edges.grey);
    const auto lines = lines_in(bytes);
    EXPECT_EQ(Bytes(lines.begin(), lines.end()), line_bytes);
}

TEST(Traced, ARefusalIsItsLineAndMayHaveLines) {
    const Result<TracedMap> none = failure("there is no line in this part");
    for (const Bytes& lines : {Bytes(), line_bytes}) {
        const auto traced = traced_of(bytes_of(none, lines).value());
        ASSERT_TRUE(traced.has_value());
        EXPECT_EQ(traced->has_lines, !lines.empty());
        ASSERT_FALSE(traced->map.has_value());
        EXPECT_EQ(traced->map.error().line, "there is no line in this part");
    }
}

TEST(Traced, TextsAreHarmless) {
    TracedMap traced = felt();
    traced.warning = "one\ntwo\x1b[2J";
    traced.map.outlines[0].label = "left\n\x07 eye";
    const auto read = traced_of(bytes_of(traced, {}).value());
    ASSERT_TRUE(read.has_value() && read->map.has_value());
    EXPECT_EQ(read->map->warning.find('\n'), std::string::npos);
    EXPECT_EQ(read->map->warning.find('\x1b'), std::string::npos);
    EXPECT_EQ(read->map->map.outlines[0].label, "left eye");
    traced.report = "\x1b[2J";
    EXPECT_FALSE(why_refused(bytes_of(traced, {}).value()).empty());
}

TEST(Traced, AMapWithoutOutlinesIsNone) {
    EXPECT_FALSE(why_refused(bytes_of(TracedMap{}, line_bytes).value()).empty());
}

TEST(Traced, EverySizeThatIsWrongIsRefused) {
    const Bytes right = bytes_of(felt(), line_bytes).value();
    // Magic, is a photograph, width, height, map, lines, the refusal's size, the warning's, the
    // report's.
    const std::size_t warning_at = 25;
    const std::size_t report_at = warning_at + 4 + felt().warning.size();
    for (const std::size_t at :
         {std::size_t{0}, std::size_t{4}, std::size_t{5}, std::size_t{9}, std::size_t{13},
          std::size_t{17}, std::size_t{21}, warning_at, report_at}) {
        for (const std::uint32_t wrong : {0x7fffffffU, 0xffffffffU, 0x101U}) {
            Bytes bytes = right;
            std::memcpy(&bytes[at], &wrong, sizeof wrong);
            EXPECT_FALSE(why_refused(bytes).empty()) << at << " " << wrong;
        }
    }
    for (std::size_t size = 0; size < right.size(); ++size)
        ASSERT_FALSE(traced_of(std::span(right).first(size)).has_value()) << size;
    Bytes longer = right;
    longer.push_back({});
    EXPECT_FALSE(traced_of(longer).has_value());
}

RC_GTEST_PROP(Traced, AnyBytesAreAMapOrOneLine, (const std::vector<std::uint8_t>& changes)) {
    Bytes bytes = bytes_of(felt(), line_bytes).value();
    for (std::size_t i = 0; i + 1 < changes.size(); i += 2)
        bytes[(changes[i] * std::size_t{7}) % bytes.size()] =
            static_cast<std::byte>(changes[i + 1]);
    const auto traced = traced_of(bytes);
    if (traced && traced->map) RC_ASSERT(!traced->map->map.outlines.empty());
    if (!traced) RC_ASSERT(traced.error().line.find('\n') == std::string::npos);
}

}  // namespace
}  // namespace touchline
