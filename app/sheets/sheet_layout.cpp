#include "app/sheets/sheet_layout.h"

#include "app/sheets/label_places.h"
#include "app/sheets/line_gaps.h"
#include "app/sheets/page_frame.h"
#include "app/sheets/paper_place.h"
#include "app/sheets/sheet_words.h"
#include "app/sheets/stroke_grid.h"
#include "config/types/extent.h"

#include <array>
#include <limits>
#include <optional>

namespace touchline {
namespace {

constexpr double most_scale = 2.0;
constexpr double scale_step = 0.92;
constexpr int most_scales = 10;
constexpr int most_worse = 3;  // sizes in a row that are no better than a larger one
constexpr double anchor_step_mm = 2.0;
constexpr double anchor_touch_mm = 0.8;
constexpr double anchor_off_end_mm = 6.0;   // a leader at an end would seem to go on with its line
constexpr double straight_over_mm = 3.0;    // on either side of an anchor
constexpr double straightest_cosine = 0.8;  // at a corner it would go on with one of its sides
constexpr std::size_t most_anchors = 20;
constexpr std::size_t most_label_cells = 24;
constexpr std::size_t most_label_rows = 4;

// What a drawing costs against its size: one step of the scale is about 0.08.
constexpr double of_unlabelled = 0.4;
constexpr double of_left_out = 0.2;
constexpr double of_broken = 0.1;
constexpr double of_leader_break = 0.03;

/// The box of all lines and places; nothing if there is no line.
std::optional<Extent> ink_of(const TactileMap& map) {
    Extent ink = extent_of(map);
    if (!ink.is_finite() || norm(ink.high - ink.low) <= 0.0) return std::nullopt;
    for (const Label& label : map.labels) ink.add(label.place);
    return ink;
}

/// Everything about a map that does not depend on its size on paper.
struct SheetMatter {
    const TactileMap& map;
    Extent ink;
    std::vector<NamedPart> parts;
    std::vector<std::vector<std::vector<BrailleCells>>> shapes;  // of each part
    FrameWords words;
    BrailleHand hand;
};

Result<SheetMatter> matter_of(const TactileMap& map, const Extent& ink, const BrailleHand& hand,
                              const Language& language) {
    SheetMatter matter{map, ink, named_parts(map), {}, {}, hand};
    for (const NamedPart& part : matter.parts) {
        const auto cells = cells_of(part.name, hand);
        if (!cells) return tl::unexpected(cells.error());
        matter.shapes.push_back(label_shapes(*cells, most_label_cells, most_label_rows));
    }
    matter.words.title = map.title;
    matter.words.up = up_words(language);
    const auto title = cells_of(matter.words.title, hand);
    const auto up = cells_of(matter.words.up, hand);
    if (!title) return tl::unexpected(title.error());
    if (!up) return tl::unexpected(up.error());
    matter.words.title_cells = *title;
    matter.words.up_cells = *up;
    return matter;
}

/// Evenly chosen.
std::vector<PaperPoint> thinned(const std::vector<PaperPoint>& points, std::size_t most) {
    std::vector<PaperPoint> kept;
    const std::size_t step = 1 + (points.size() - (points.empty() ? 0 : 1)) / most;
    for (std::size_t i = step / 2; i < points.size(); i += step) kept.push_back(points[i]);
    return kept;
}

/// A leader here would not seem to go on with the line: no end is near, and no corner.
bool is_plain_place(const std::vector<PaperPoint>& points, std::size_t i, bool is_ring) {
    const auto n = static_cast<std::ptrdiff_t>(points.size()) - (is_ring ? 1 : 0);
    const auto at = static_cast<std::ptrdiff_t>(i);
    const auto beside = [&](std::ptrdiff_t by) -> std::optional<PaperPoint> {
        double way_mm = 0.0;
        std::ptrdiff_t k = at;
        while (way_mm < straight_over_mm) {
            const std::ptrdiff_t next = is_ring ? (k + by + n) % n : k + by;
            if (next < 0 || next >= n || next == at) return std::nullopt;
            way_mm += distance_mm(points[static_cast<std::size_t>(k)],
                                  points[static_cast<std::size_t>(next)]);
            k = next;
        }
        return points[static_cast<std::size_t>(k)];
    };
    const auto before = beside(-1);
    const auto after = beside(+1);
    if (!before || !after) return false;
    const bool is_off_ends =
        is_ring || (distance_mm(points.front(), points[i]) > anchor_off_end_mm &&
                    distance_mm(points.back(), points[i]) > anchor_off_end_mm);
    const PaperPoint in{points[i].x_mm - before->x_mm, points[i].y_mm - before->y_mm};
    const PaperPoint out{after->x_mm - points[i].x_mm, after->y_mm - points[i].y_mm};
    const double both = std::hypot(in.x_mm, in.y_mm) * std::hypot(out.x_mm, out.y_mm);
    return is_off_ends && in.x_mm * out.x_mm + in.y_mm * out.y_mm >= straightest_cosine * both;
}

/// Where a leader may end on the drawn lines of a part: away from all other lines if it can be.
std::vector<PaperPoint> anchors_of(const NamedPart& part, const std::vector<SheetStroke>& shapes,
                                   const StrokeGrid& lines) {
    std::vector<PaperPoint> free;
    std::vector<std::pair<double, PaperPoint>> others;
    for (const std::size_t i : part.outlines) {
        const std::vector<PaperPoint> points = sampled(shapes[i], anchor_step_mm);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const PaperPoint p = points[k];
            if (lines.near(p).centre_mm > anchor_touch_mm) continue;
            const double clear_mm = lines.near(p, i).clear_mm;
            if (clear_mm > 2.0 * least_clear_mm && is_plain_place(points, k, shapes[i].is_closed)) {
                free.push_back(p);
            } else {
                others.emplace_back(clear_mm, p);
            }
        }
    }
    if (!free.empty()) return thinned(free, most_anchors);
    std::ranges::stable_sort(others, std::ranges::greater{}, &std::pair<double, PaperPoint>::first);
    for (const auto& [clear, p] : others)
        if (free.size() < most_anchors / 2) free.push_back(p);
    return free;
}

std::vector<WantedLabel> wanted_labels(const SheetMatter& matter, const PaperPlace& place,
                                       const std::vector<SheetStroke>& shapes,
                                       const StrokeGrid& lines) {
    std::vector<WantedLabel> wanted;
    for (std::size_t i = 0; i < matter.parts.size(); ++i) {
        const NamedPart& part = matter.parts[i];
        WantedLabel label{i, {}, part.outlines.empty(), matter.shapes[i]};
        if (label.is_place) {
            label.anchors.push_back(place(part.place));
        } else {
            label.anchors = anchors_of(part, shapes, lines);
        }
        if (!label.anchors.empty() && !label.shapes.empty()) wanted.push_back(std::move(label));
    }
    return wanted;
}

/// The first page at one size, and what it costs.
struct DrawnPage {
    PaperPage page;
    double scale = 1.0;
    std::vector<std::string> left_out;
    std::vector<std::string> unlabelled;
    int breaks = 0;  // of leaders
    double cost = std::numeric_limits<double>::infinity();
};

/// The names of these outlines, each once; those without a name have one together.
std::vector<std::string> names_of(const TactileMap& map, const PaperLines& lines,
                                  const std::string& nameless) {
    std::vector<std::string> names;
    std::vector<std::size_t> all = lines.left_out;
    all.insert(all.end(), lines.broken.begin(), lines.broken.end());
    for (const std::size_t i : all) {
        const std::string& label = map.outlines[i].label;
        const std::string& name = label.empty() ? nameless : label;
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

/// The words around a drawing of this size.
Result<FrameWords> words_at(const SheetMatter& matter, double scale, const Language& language) {
    FrameWords words = matter.words;
    words.scale = scale_words(scale, language);
    return cells_of(words.scale, matter.hand).map([&words](BrailleCells cells) {
        words.scale_cells = std::move(cells);
        return words;
    });
}

Result<DrawnPage> drawn_at(const SheetMatter& matter, PaperSize size, double scale,
                           const Language& language) {
    const auto words = words_at(matter, scale, language);
    if (!words) return tl::unexpected(words.error());
    PageFrame frame = page_frame(size, *words);

    const PaperPlace place = middle_place(matter.ink, frame.zone, scale);
    const std::vector<SheetStroke> shapes = whole_lines(matter.map, place);
    PaperLines lines = paper_lines(matter.map, place, size);
    StrokeGrid grid(size, 3.0 * least_clear_mm);
    for (const SheetStroke& stroke : lines.strokes) grid.add(stroke);
    LabelPlan plan = placed_labels(wanted_labels(matter, place, shapes, grid), lines.strokes,
                                   shapes, size, frame.zone);

    DrawnPage drawn{std::move(frame.page), scale, {}, {}, plan.breaks, 0.0};
    drawn.left_out = names_of(matter.map, lines, language.text("sheet", "lines without a name"));
    std::ranges::move(lines.strokes, std::back_inserter(drawn.page.strokes));
    for (PlacedLabel& label : plan.placed) {
        for (SheetStroke& piece : label.leader) {
            piece.source = drawn.page.blocks.size();
            drawn.page.strokes.push_back(std::move(piece));
        }
        drawn.page.blocks.push_back({matter.parts[label.part].name, std::move(label.rows)});
    }
    for (const std::size_t part : plan.without_room)
        drawn.unlabelled.push_back(matter.parts[part].name);
    drawn.cost = of_unlabelled * static_cast<double>(plan.without_room.size()) +
                 of_left_out * static_cast<double>(lines.left_out.size()) +
                 of_broken * static_cast<double>(lines.broken.size()) +
                 of_leader_break * plan.breaks - std::log(scale);
    return drawn;
}

/// The largest scale at which the lines fit into a zone; 0 if there is none.
double largest_scale(const Extent& ink, const PaperBox& zone) {
    const PaperSize room{zone.width_mm() - outer_line_mm, zone.height_mm() - outer_line_mm};
    if (!(std::min(room.width_mm, room.height_mm) > 0.0)) return 0.0;
    return fitting_scale(ink, room, most_scale);
}

/// The best of one position of the paper, if anything fits there.
Result<DrawnPage> best_page(const SheetMatter& matter, PaperSize size, const Language& language) {
    DrawnPage best;
    const auto words = words_at(matter, 1.0, language);
    if (!words) return tl::unexpected(words.error());
    int worse = 0;  // sizes in a row
    double scale = largest_scale(matter.ink, page_frame(size, *words).zone);
    for (int i = 0; i < most_scales && scale > 0.0; ++i, scale *= scale_step) {
        if (best.cost <= -std::log(scale)) break;  // no smaller one is better
        auto drawn = drawn_at(matter, size, scale, language);
        if (!drawn) return drawn;
        const bool is_whole = drawn->unlabelled.empty() && drawn->breaks == 0;
        worse = drawn->cost < best.cost ? 0 : worse + 1;
        if (worse == 0) best = std::move(*drawn);
        if (is_whole || worse == most_worse) break;  // smaller ones only lose lines
    }
    return best;
}

/// Pages of words.
void add_words(const std::vector<BrailleCells>& lines, PaperSize size, TactileSheet& sheet) {
    const PaperBox area = printable(size);
    const std::size_t rows = rows_in(area.height_mm() - foot_mm);
    const double half_mm = braille_dot_mm / 2.0;
    for (std::size_t begin = 0; begin < lines.size(); begin += rows) {
        PaperPage page{size, {}, {}, {}};
        BrailleBlock block;
        for (std::size_t i = begin; i < std::min(begin + rows, lines.size()); ++i)
            block.rows.push_back(
                {{area.left_mm + half_mm,
                  area.top_mm + half_mm + static_cast<double>(i - begin) * braille_line_mm},
                 lines[i]});
        page.blocks.push_back(std::move(block));
        sheet.pages.push_back(std::move(page));
    }
}

}  // namespace

Result<TactileSheet> tactile_sheet(const TactileMap& map, const SheetOrder& order,
                                   const Language& language) {
    const auto ink = ink_of(map);
    if (!ink) return failure("there is no line to print");
    if (const auto few = check_parts(map); !few) return tl::unexpected(few.error());
    const auto matter = matter_of(map, *ink, order.hand, language);
    if (!matter) return tl::unexpected(matter.error());
    const PaperSize upright = size_of(order.paper);
    DrawnPage best;
    for (const PaperSize size : {PaperSize{upright.height_mm, upright.width_mm}, upright}) {
        auto drawn = best_page(*matter, size, language);
        if (!drawn) return tl::unexpected(drawn.error());
        if (drawn->cost < best.cost) best = std::move(*drawn);
    }
    if (best.page.strokes.empty()) return failure("the title leaves no room for the lines");

    TactileSheet sheet{{std::move(best.page)}, best.scale, best.left_out, best.unlabelled};
    const PaperSize size = sheet.pages.front().size;
    const auto lines =
        braille_lines(paragraphs_of(map, {best.scale, best.left_out, best.unlabelled}, language),
                      cells_in(printable(size).width_mm()), order.hand);
    if (!lines) return tl::unexpected(lines.error());
    add_words(*lines, size, sheet);
    for (std::size_t i = 0; i < sheet.pages.size(); ++i)
        sheet.pages[i].prints.push_back(foot_of(size, map.title, i + 1, sheet.pages.size()));
    return sheet;
}

}  // namespace touchline
