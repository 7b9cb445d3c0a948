#include "config/settings/boards.h"

#include "config/settings/settings_text.h"

#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>

#include <toml++/toml.h>

namespace touchline {
namespace {

/// Reads one table key by key, and keeps the first fault in `wrong`.
class TableReader {
  public:
    TableReader(const toml::table& table, std::string_view file) : table_(table), file_(file) {}

    /// Stops at a key that is not in `keys`.
    void allow(std::initializer_list<std::string_view> keys) {
        for (const auto& [key, value] : table_)
            if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
                blame(value, "'" + std::string(key.str()) + "' is not a setting here");
    }

    template <class T>
    std::optional<T> read(std::string_view key, std::string_view what, bool is_needed) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) {
            if (is_needed) blame(table_, "'" + std::string(key) + "' is missing");
            return std::nullopt;
        }
        const auto value = node->value<T>();
        if (!value) blame_value(*node, key, std::string(what));
        return value;
    }

    std::uint16_t read_id(std::string_view key) {
        const auto id = read<std::int64_t>(key, "a number from 1 to 0xffff", true);
        if (id && (*id < 1 || *id > 0xffff))
            blame_value(*table_.get(key), key, "a number from 1 to 0xffff");
        return static_cast<std::uint16_t>(id.value_or(0));
    }

    bool read_flag(std::string_view key) {
        return read<bool>(key, "true or false", false).value_or(false);
    }

    /// Reads [joint 1, joint 2].
    std::pair<bool, bool> read_flags(std::string_view key) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return {};
        const toml::array* pair = node->as_array();
        const bool is_pair = pair != nullptr && pair->size() == 2;
        const auto one = is_pair ? pair->get(0)->value_exact<bool>() : std::nullopt;
        const auto two = is_pair ? pair->get(1)->value_exact<bool>() : std::nullopt;
        if (!one || !two) blame_value(*node, key, "true or false twice, one a joint");
        return {one.value_or(false), two.value_or(false)};
    }

    /// Reads [joint 1, joint 2].
    std::optional<JointAngles> read_pair(std::string_view key, double least, double greatest) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return std::nullopt;
        const toml::array* pair = node->as_array();
        const auto at = [&](std::size_t i) {
            const auto value = pair->get(i)->value<double>();
            return value && *value >= least && *value <= greatest ? value : std::nullopt;
        };
        if (pair != nullptr && pair->size() == 2 && at(0) && at(1))
            return JointAngles{*at(0), *at(1)};
        blame_value(*node, key, "two numbers, one a joint, " + range(least, greatest));
        return std::nullopt;
    }

    /// Returns nothing if the key is missing.
    std::optional<double> read_number(std::string_view key, double least, double greatest) {
        const auto value = read<double>(key, "a number", false);
        if (value && !(*value >= least && *value <= greatest))
            blame_value(*table_.get(key), key, "a number " + range(least, greatest));
        return value;
    }

    void blame(const toml::node& node, const std::string& why) {
        if (!wrong.empty()) return;
        wrong = line_in_file(file_, node.source().begin.line, why);
    }

    std::string wrong;

  private:
    void blame_value(const toml::node& node, std::string_view key, const std::string& what) {
        blame(node, "'" + std::string(key) + "' must be " + what);
    }

    static std::string range(double least, double greatest) {
        std::ostringstream text;
        text << "from " << least << " to " << greatest;
        return text.str();
    }

    const toml::table& table_;
    std::string file_;
};

BoardId read_board(TableReader& reader, const toml::table& table) {
    reader.allow({"vendor", "product", "state", "probe", "name"});
    BoardId id;
    id.vendor = reader.read_id("vendor");
    id.product = reader.read_id("product");
    const auto state = reader.read<std::string>("state", "a text", true).value_or("running");
    if (state == "needs-firmware") {
        id.condition = BoardCondition::needs_firmware;
    } else if (state == "wrong-socket") {
        id.condition = BoardCondition::wrong_socket;
    } else if (state != "running") {
        reader.blame(*table.get("state"),
                     "'state' must be running, needs-firmware or wrong-socket");
    }
    id.may_probe = reader.read<bool>("probe", "true or false", false).value_or(false);
    id.name = reader.read<std::string>("name", "a text", true).value_or("");
    return id;
}

Plugs read_plugs(TableReader& reader, const std::string& what) {
    const auto [is_1_reversed, is_2_reversed] = reader.read_flags("reversed_" + what);
    return {reader.read_flag("swapped_" + what), is_1_reversed, is_2_reversed};
}

std::optional<double> read_torque_limit(TableReader& reader, const toml::table& table) {
    const auto limit_Nm = reader.read<double>("torque_limit_Nm", "a number", false);
    const double limit = limit_Nm.value_or(greatest_torque_limit_Nm);
    if (!(limit > 0.0 && limit <= greatest_torque_limit_Nm))
        reader.blame(*table.get("torque_limit_Nm"),
                     "'torque_limit_Nm' must be above 0 and at most 1");
    return limit_Nm;
}

/// Version 0 had a scale and an offset for each joint, and assumed the kind.
bool is_of_version_0(const toml::table& table) {
    return table.contains("offset_rad") || table["scale"].is_array();
}

UnitSettings read_unit_of_version_0(TableReader& reader, const toml::table& table) {
    reader.allow({"serial", "profile", "swapped_motors", "scale", "offset_rad", "torque_limit_Nm"});
    UnitSettings unit;
    unit.serial = reader.read<std::string>("serial", "a text", true).value_or("");
    unit.calibration.torque_limit_Nm = read_torque_limit(reader, table);
    return unit;
}

UnitSettings read_unit(TableReader& reader, const toml::table& table) {
    if (is_of_version_0(table)) return read_unit_of_version_0(reader, table);
    reader.allow({"serial", "profile", "measured", "scale", "stop_off_rad", "swapped_encoders",
                  "reversed_encoders", "swapped_motors", "reversed_motors", "all_counts",
                  "torque_limit_Nm"});
    UnitSettings unit;
    unit.serial = reader.read<std::string>("serial", "a text", true).value_or("");
    unit.profile = reader.read<std::string>("profile", "a text", true).value_or("");
    Calibration& calibration = unit.calibration;
    calibration.is_measured = reader.read_flag("measured");
    calibration.scale =
        reader.read_number("scale", least_scale, greatest_scale).value_or(calibration.scale);
    calibration.stop_off =
        reader.read_pair("stop_off_rad", -greatest_stop_off_rad, greatest_stop_off_rad)
            .value_or(calibration.stop_off);
    calibration.encoders = read_plugs(reader, "encoders");
    calibration.motors = read_plugs(reader, "motors");
    calibration.has_all_counts = reader.read_flag("all_counts");
    calibration.torque_limit_Nm = read_torque_limit(reader, table);
    return unit;
}

/// Reads every table of the array `key` by `read`; an empty list if it is missing.
template <class T, class Read>
Result<std::vector<T>> read_all(const toml::table& file, std::string_view name,
                                std::string_view key, Read read) {
    std::vector<T> all;
    const toml::node* node = file.get(key);
    if (node == nullptr) return all;
    TableReader outer(file, name);
    const toml::array* tables = node->as_array();
    if (tables == nullptr || !tables->is_homogeneous(toml::node_type::table)) {
        outer.blame(*node,
                    "'" + std::string(key) + "' must be written as [[" + std::string(key) + "]]");
        return failure(outer.wrong);
    }
    for (const toml::node& element : *tables) {
        TableReader reader(*element.as_table(), name);
        all.push_back(read(reader, *element.as_table()));
        if (!reader.wrong.empty()) return failure(reader.wrong);
    }
    return all;
}

std::string notice_of(const toml::table& file, std::string_view name) {
    const toml::array* const units = file["unit"].as_array();
    if (units == nullptr) return {};
    const auto is_old = [](const toml::node& unit) { return is_of_version_0(*unit.as_table()); };
    if (std::none_of(units->begin(), units->end(), is_old)) return {};
    return std::string(name) +
           ": what an earlier version stored for a handle no longer counts: choose the kind of "
           "handle, and it is measured anew";
}

Result<BoardSettings> read_tables(const toml::table& file, std::string_view name) {
    TableReader outer(file, name);
    outer.allow({"board", "unit"});
    if (!outer.wrong.empty()) return failure(outer.wrong);
    auto boards = read_all<BoardId>(file, name, "board", read_board);
    if (!boards) return tl::unexpected(boards.error());
    auto units = read_all<UnitSettings>(file, name, "unit", read_unit);
    if (!units) return tl::unexpected(units.error());
    return BoardSettings{std::move(*boards), std::move(*units), notice_of(file, name)};
}

toml::array pair_of(JointAngles pair) {
    return toml::array{pair.x, pair.y};
}

toml::array reversed_of(const Plugs& plugs) {
    return toml::array{plugs.is_1_reversed, plugs.is_2_reversed};
}

}  // namespace

Result<BoardSettings> parse_boards(std::string_view text, std::string_view name) {
    try {
        return read_tables(toml::parse(text), name);
    } catch (const toml::parse_error& error) {
        return failure(
            line_in_file(name, error.source().begin.line, std::string(error.description())));
    }
}

Result<BoardSettings> read_boards(const std::filesystem::path& file) {
    const auto text = read_settings_file(file);
    if (!text) return tl::unexpected(text.error());
    return parse_boards(*text, file.string());
}

std::string units_text(const std::vector<UnitSettings>& units) {
    std::ostringstream text;
    for (const UnitSettings& unit : units) {
        const Calibration& calibration = unit.calibration;
        toml::table table{{"serial", unit.serial},
                          {"profile", unit.profile},
                          {"measured", calibration.is_measured},
                          {"scale", calibration.scale},
                          {"stop_off_rad", pair_of(calibration.stop_off)},
                          {"swapped_encoders", calibration.encoders.are_swapped},
                          {"reversed_encoders", reversed_of(calibration.encoders)},
                          {"swapped_motors", calibration.motors.are_swapped},
                          {"reversed_motors", reversed_of(calibration.motors)},
                          {"all_counts", calibration.has_all_counts}};
        if (calibration.torque_limit_Nm)
            table.insert("torque_limit_Nm", *calibration.torque_limit_Nm);
        text << "[[unit]]\n" << table << "\n\n";
    }
    return text.str();
}

}  // namespace touchline
