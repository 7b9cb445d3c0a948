#include "app/documents/decode/map_svg.h"
#include "app/documents/decode/svg_survey.h"
#include "app/documents/packs/unpack_work.h"
#include "config/types/map_bytes.h"
#include "vision/simplify/detail_limits.h"

#include <set>

namespace touchline {
namespace {

constexpr std::size_t most_near_lines = 5;

UnpackAnswer broken(const std::string& why, int line = 0) {
    return {0, {{FindingKind::picture_broken, "", line, why, 0.0}}, {}};
}

std::string name_of(const Outline& outline) {
    if (!outline.label.empty()) return outline.label;
    return outline.id.empty() ? "?" : outline.id;
}

void look_at_words(const SvgSurvey& survey, const std::vector<std::string>& languages,
                   std::vector<PackFinding>& findings) {
    const auto look = [&](const SaidLanguages& said, FindingKind missing, FindingKind in_one,
                          const std::string& part, int line) {
        if (said.empty()) {
            findings.push_back({missing, "", line, part, 0.0});
            return;
        }
        for (const std::string& language : languages) {
            if (speaks(said, language, languages.front())) continue;
            const std::string what = part.empty() ? language : "“" + part + "” (" + language + ")";
            findings.push_back({in_one, "", line, what, 0.0});
        }
    };
    look(survey.title, FindingKind::no_title, FindingKind::title_language, "", 0);
    look(survey.description, FindingKind::no_description, FindingKind::description_language, "", 0);
    for (const SurveyedPart& part : survey.parts)
        look(part.name, FindingKind::no_part_name, FindingKind::part_language,
             part.id.empty() ? "?" : part.id, part.line);
}

void look_at_names(const TactileMap& map, std::vector<PackFinding>& findings) {
    std::set<std::string> labels;
    std::set<std::string> told;
    std::string last;
    for (const Outline& outline : map.outlines) {
        // The subpaths of one shape share its name and follow each other.
        const bool is_other = !outline.label.empty() && outline.label != last;
        if (is_other && !labels.insert(outline.label).second && told.insert(outline.label).second)
            findings.push_back({FindingKind::same_name, "", 0, outline.label, 0.0});
        last = outline.label;
    }
}

void look_at_lines(const TactileMap& map, int difficulty, std::vector<PackFinding>& findings) {
    if (map.area != Area{}) findings.push_back({FindingKind::other_size});
    for (const NearLines& near : near_lines(map, most_near_lines)) {
        const std::string pair = "“" + name_of(map.outlines[near.one]) + "”, “" +
                                 name_of(map.outlines[near.other]) + "”";
        findings.push_back({FindingKind::lines_near, "", 0, pair, 1000.0 * near.gap_m});
    }
    const auto parts = part_count(map);
    if (difficulty > 0 && parts > static_cast<std::size_t>(most_parts(difficulty)))
        findings.push_back({FindingKind::many_parts, "", 0, std::to_string(difficulty),
                            static_cast<double>(parts)});
    const double line_mm = 1000.0 * line_length_m(map);
    if (line_mm > limits_for(most_detail, map.area).line_mm)
        findings.push_back({FindingKind::much_line, "", 0, "", line_mm});
    for (const Outline& outline : map.outlines)
        if (is_near_rim(outline, map.area))
            findings.push_back({FindingKind::near_rim, "", 0, name_of(outline), 0.0});
}

}  // namespace

UnpackAnswer check_picture(std::string_view svg, const std::vector<std::string>& languages) {
    if (const int line = xml_error_line(svg); line > 0)
        return broken("it is no whole XML; save it again as SVG", line);
    std::string made;
    if (has_image_layers(svg)) {
        auto map_svg = map_svg_of_image_layers(svg, Area{});
        if (!map_svg) return broken(map_svg.error().line);
        made = std::move(*map_svg);
        svg = made;
    }
    const auto map = parse_map_svg(svg, {languages.front()});
    if (!map) return broken(map.error().line);
    const auto difficulty = difficulty_of_map_svg(svg);
    if (!difficulty) return broken(difficulty.error().line);
    auto bytes = bytes_of(*map);
    if (!bytes) return broken(bytes.error().line);
    const auto survey = survey_svg(svg);
    if (!survey) return broken(survey.error().line);
    UnpackAnswer answer{difficulty->value_or(0), {}, {{map_entry, std::move(*bytes)}}};
    look_at_words(*survey, languages, answer.findings);
    look_at_names(*map, answer.findings);
    look_at_lines(*map, answer.difficulty, answer.findings);
    return answer;
}

UnpackAnswer picture_in_layers(std::string_view svg, const std::string& language) {
    const auto made = image_layers_of_map_svg(svg, {language});
    if (!made) return broken(made.error().line);
    const auto bytes = std::as_bytes(std::span(*made));
    return {0, {}, {{picture_entry, {bytes.begin(), bytes.end()}}}};
}

}  // namespace touchline
