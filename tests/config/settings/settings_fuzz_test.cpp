// Tests every key of the settings with every kind of wrong value: one line names file, line, key
// and what is allowed, and nothing of the file is applied.
#include "config/settings/settings_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

/// TOML values of every type and size, and values that are not numbers.
const std::vector<std::string>& values() {
    static const std::vector<std::string> all{"true",
                                              "false",
                                              "0",
                                              "-1",
                                              "1",
                                              "3",
                                              "1000000",
                                              "9223372036854775807",
                                              "0.5",
                                              "-0.001",
                                              "1e300",
                                              "-1e300",
                                              "5e-324",
                                              "nan",
                                              "+inf",
                                              "-inf",
                                              "''",
                                              "'1'",
                                              "'wall'",
                                              "'on'",
                                              "'/x'",
                                              "'en'",
                                              "'09:00-17:00'",
                                              "'../../etc'",
                                              "\"\\u0000\"",
                                              "\"a\\nb\"",
                                              "[]",
                                              "[1, 2]",
                                              "{}",
                                              "{ a = 1 }",
                                              "1979-05-27",
                                              "07:32:00",
                                              "1979-05-27T07:32:00Z",
                                              "0xffff",
                                              "'" + std::string(5000, 'x') + "'"};
    return all;
}

TEST(SettingsFuzz, EveryKeyTakesOnlyWhatItsRowAllows) {
    Settings base;
    base.friction = 0.7;
    int refused = 0;
    int taken = 0;
    for (const SettingRow& row : setting_rows()) {
        const std::string key = std::string(row.table) + '.' + std::string(row.key);
        for (const std::string& value : values()) {
            const std::string text = "# site\n[" + std::string(row.table) + "]\n" +
                                     std::string(row.key) + " = " + value + "\n";
            const auto settings = apply_settings(base, text, "site.toml", SettingLayer::site);
            if (settings) {
                ++taken;
                EXPECT_TRUE(with_value(base, row, value_of(*settings, row))) << text;
                for (const SettingRow& other : setting_rows())
                    EXPECT_TRUE(&other == &row ||
                                value_of(*settings, other) == value_of(base, other))
                        << text << other.key;
                continue;
            }
            ++refused;
            const std::string& line = settings.error().line;
            EXPECT_EQ(line.find('\n'), std::string::npos);
            EXPECT_TRUE(line.starts_with("site.toml:")) << line;
            EXPECT_NE(line.find('\'' + key + '\''), std::string::npos) << line;
            const bool is_between_settings = line.find("must be one of") != std::string::npos ||
                                             line.find("must not be above") != std::string::npos;
            if (is_between_settings) continue;
            EXPECT_TRUE(line.starts_with("site.toml:3: ")) << line;
            EXPECT_NE(line.find(allowed_values(row)), std::string::npos) << line;
        }
    }
    EXPECT_GT(taken, 60);
    EXPECT_GT(refused, 1000);
}

TEST(SettingsFuzz, AnyOtherNameIsRefused) {
    for (const SettingRow& row : setting_rows()) {
        const std::string table(row.table);
        for (const std::string& key : {std::string(row.key) + "_", "x" + std::string(row.key),
                                       std::string("feel.") + std::string(row.key) + "2"}) {
            const auto settings =
                apply_settings({}, "[" + table + "]\n'" + key + "' = 1\n", "f", SettingLayer::site);
            ASSERT_FALSE(settings);
            EXPECT_EQ(settings.error().line, "f:2: '" + table + '.' + key + "' is not a setting");
        }
    }
}

/// One wrong value anywhere makes a good file wrong as a whole.
RC_GTEST_PROP(SettingsFuzz, OneWrongValueSpoilsTheFile, ()) {
    const auto rows = setting_rows();
    const auto at = *rc::gen::inRange<std::size_t>(0, rows.size());
    std::string text = settings_text(Settings{});
    const std::string key = '\n' + std::string(rows[at].key) + " = ";
    const auto table = text.find('[' + std::string(rows[at].table) + ']');
    const auto begin = text.find(key, table) + key.size();
    const auto end = text.find('\n', begin);
    text.replace(begin, end - begin,
                 *rc::gen::elementOf(
                     std::vector<std::string>{"nan", "[1]", "1e301", "1979-05-27", "\"a\\tb\""}));
    const auto settings = apply_settings({}, text, "f", SettingLayer::site);
    RC_ASSERT(!settings.has_value());
    RC_ASSERT(settings.error().line.find(std::string(rows[at].key)) != std::string::npos);
}

/// A file may be cut at any byte: the rest is judged as a file, and is either sound or one line.
TEST(SettingsFuzz, CutOffAnywhereIsSoundOrOneLine) {
    const std::string whole = settings_text(Settings{});
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const auto settings = apply_settings({}, whole.substr(0, length), "f", SettingLayer::site);
        if (!settings) {
            EXPECT_TRUE(settings.error().line.starts_with("f:")) << length;
            continue;
        }
        for (const SettingRow& row : setting_rows())
            EXPECT_TRUE(with_value({}, row, value_of(*settings, row))) << row.key;
    }
}

TEST(SettingsFuzz, RowsThatATextSetsAreFound) {
    EXPECT_TRUE(rows_in("").empty());
    EXPECT_TRUE(rows_in("[feel").empty());
    EXPECT_EQ(rows_in(settings_text(Settings{})).size(), setting_rows().size());
    for (std::size_t i = 0; i < setting_rows().size(); ++i) {
        const SettingRow& row = setting_rows()[i];
        const std::string text =
            "[" + std::string(row.table) + "]\n" + std::string(row.key) + " = 1\n";
        EXPECT_EQ(rows_in(text), std::vector{i});
    }
}

}  // namespace
}  // namespace touchline
