#include "config/settings/stand.h"

#include <algorithm>
#include <sstream>

#include <toml++/toml.h>

namespace touchline {
namespace {

constexpr int greatest_side_px = 65536;
constexpr double least_bed_mm = 50.0;
constexpr double greatest_bed_mm = 2000.0;

std::string placed(std::string_view name, const toml::source_region& source,
                   const std::string& why) {
    return std::string(name) + ":" + std::to_string(source.begin.line) + ": " + why;
}

/// The first thing that is wrong stays in `wrong`.
struct Reader {
    const toml::table& table;
    std::string_view name;
    std::string wrong;

    void blame(const toml::node& node, const std::string& why) {
        if (wrong.empty()) wrong = placed(name, node.source(), why);
    }

    double number(std::string_view key, double least, double greatest) {
        const toml::node* node = table.get(key);
        const auto value = node == nullptr ? std::nullopt : node->value<double>();
        if (value && *value >= least && *value <= greatest) return *value;
        blame(node == nullptr ? table : *node, "'" + std::string(key) + "' must be a number from " +
                                                   std::to_string(static_cast<int>(least)) +
                                                   " to " +
                                                   std::to_string(static_cast<int>(greatest)));
        return least;
    }

    std::array<double, 8> corners(std::string_view key) {
        std::array<double, 8> all{};
        const toml::array* array = table[key].as_array();
        bool is_right = array != nullptr && array->size() == all.size();
        for (std::size_t i = 0; is_right && i < all.size(); ++i) {
            const auto value = array->get(i)->value<double>();
            is_right = value && *value >= -1.0 && *value <= greatest_side_px;
            all[i] = value.value_or(0.0);
        }
        if (!is_right)
            blame(array == nullptr ? static_cast<const toml::node&>(table) : *array,
                  "'" + std::string(key) + "' must be eight places in the picture");
        return all;
    }
};

Result<StandSettings> read_table(const toml::table& table, std::string_view name) {
    Reader reader{table, name, {}};
    const std::array<std::string_view, 5> known{"picture_width_px", "picture_height_px",
                                                "bed_corners_px", "bed_width_mm", "bed_height_mm"};
    for (const auto& [key, value] : table)
        if (std::find(known.begin(), known.end(), key.str()) == known.end())
            reader.blame(value, "'" + std::string(key.str()) + "' is not a setting here");
    StandSettings stand;
    stand.picture_width_px = static_cast<int>(reader.number(known[0], 1, greatest_side_px));
    stand.picture_height_px = static_cast<int>(reader.number(known[1], 1, greatest_side_px));
    stand.bed_corners_px = reader.corners(known[2]);
    stand.bed_width_mm = reader.number(known[3], least_bed_mm, greatest_bed_mm);
    stand.bed_height_mm = reader.number(known[4], least_bed_mm, greatest_bed_mm);
    if (!reader.wrong.empty()) return failure(reader.wrong);
    return stand;
}

}  // namespace

Result<StandSettings> parse_stand(std::string_view text, std::string_view name) {
    try {
        return read_table(toml::parse(text), name);
    } catch (const toml::parse_error& error) {
        std::string why(error.description());
        std::replace(why.begin(), why.end(), '\n', ' ');
        return failure(placed(name, error.source(), why));
    }
}

std::string stand_text(const StandSettings& stand) {
    toml::array corners;
    for (const double place_px : stand.bed_corners_px) corners.push_back(place_px);
    const toml::table table{{"picture_width_px", stand.picture_width_px},
                            {"picture_height_px", stand.picture_height_px},
                            {"bed_corners_px", corners},
                            {"bed_width_mm", stand.bed_width_mm},
                            {"bed_height_mm", stand.bed_height_mm}};
    std::ostringstream text;
    text << table << '\n';
    return text.str();
}

}  // namespace touchline
