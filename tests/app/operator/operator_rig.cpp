#include "tests/app/operator/operator_rig.h"

#include "app/operator/backup.h"
#include "app/operator/pin.h"
#include "app/operator/settings_files.h"

#include <utility>

#include <gtest/gtest.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

fs::path new_folder() {
    static int count = 0;
    return fs::path(testing::TempDir()) /
           ("touchline-operator-" + std::to_string(getpid()) + "-" + std::to_string(++count));
}

std::string line_of(const Result<void>& result, const std::string& good) {
    return result ? good : result.error().line;
}

}  // namespace

OperatorRig::OperatorRig(Language words) : language(std::move(words)), folder(new_folder()) {
    stick = folder / "stick";
    fs::create_directories(stick);
    files = {folder / "kiosk.toml", folder / "kiosk.toml.good"};
    std::vector<std::string> problems;
    profiles = read_profiles(TOUCHLINE_SOURCE_DIR "/config/defaults/profiles", problems);
}

OperatorRig::~OperatorRig() {
    fs::remove_all(folder);
}

OperatorWorld OperatorRig::world() const {
    std::vector<OfferedProfile> offered;
    for (const Profile& profile : profiles) offered.push_back({profile.name, profile.rows});
    const Settings settings = in_memory ? *in_memory : read_settings(files).settings;
    return {
        language,
        now_s,
        has_pin(folder / "operator.pin"),
        settings,
        sound,
        keys,
        {{"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}, {"es", "Español"}},
        std::move(offered),
        days,
        packs,
        house_files,
        house_lines,
        {is_private, {"Force 0.5 newtons", "Level 2"}, kind, bounds, device_words, today, health}};
}

SpokenScreen OperatorRig::screen() const {
    return operator_screen(state, world());
}

void OperatorRig::take(const OperatorEvent& event) {
    OperatorStep step = step_operator(state, event, world());
    state = std::move(step.state);
    for (const OperatorOrder& order : step.orders) {
        orders.push_back(order);
        carry_out(order);
    }
}

void OperatorRig::carry_out(const OperatorOrder& order) {
    if (const auto* say = std::get_if<Say>(&order)) {
        heard_ += say->text + '\n';
        shown = say->text;
    }
    if (const auto* show = std::get_if<Show>(&order)) shown = show->text;
    if (const auto* set = std::get_if<SetSettings>(&order)) felt = set->settings;
    if (const auto* write = std::get_if<WriteSettings>(&order)) {
        felt = write->settings;
        if (in_memory) {
            in_memory = write->settings;
        } else {
            EXPECT_TRUE(keep_settings(files, write->settings));
        }
    }
    if (const auto* write = std::get_if<WriteSound>(&order)) {
        sound = write->sound;
        EXPECT_TRUE(keep_sound(folder / "sound.toml", sound));
    }
    if (const auto* write = std::get_if<WriteKeys>(&order)) {
        EXPECT_TRUE(keep_keys(folder / "keys.toml", write->keys));
        keys = read_keys(folder / "keys.toml").keys;
    }
    if (const auto* keep = std::get_if<KeepPin>(&order)) {
        EXPECT_TRUE(keep_pin(folder / "operator.pin", keep->pin));
    }
    if (const auto* check = std::get_if<CheckPin>(&order))
        take(PinChecked{is_right_pin(folder / "operator.pin", check->pin).value_or(false)});
    if (const auto* run = std::get_if<RunTest>(&order); run != nullptr && answers_tests)
        take(TestAnswered{run->step, passes_tests, ""});
    if (std::holds_alternative<BackUp>(order))
        take(OrderAnswered{
            line_of(write_backup(stick, {world().settings, sound, keys}), "The backup is made.")});
    if (std::holds_alternative<Restore>(order)) {
        const auto backup = read_backup(stick);
        if (!backup) return take(OrderAnswered{backup.error().line});
        EXPECT_TRUE(keep_settings(files, backup->settings));
        sound = backup->sound;
        keys = backup->keys;
        take(OrderAnswered{"The settings are those of the stick."});
    }
}

void OperatorRig::press(std::initializer_list<KeyRole> roles) {
    for (const KeyRole role : roles) {
        now_s += 0.5;
        const auto of_role = keys_of(keys, role);
        ASSERT_FALSE(of_role.empty());
        take(KeyStruck{of_role.front(), role, is_device_allowed});
    }
}

void OperatorRig::press_key(const PhysicalKey& key) {
    now_s += 0.5;
    take(KeyStruck{key, role_of(keys, key), is_device_allowed});
}

void OperatorRig::wait(double time_s) {
    for (double waited_s = 0.0; waited_s < time_s; waited_s += 1.0) {
        now_s += 1.0;
        take(MomentPassed{});
    }
}

void OperatorRig::enter() {
    using R = KeyRole;
    press({R::help, R::up, R::up, R::down, R::down, R::select});
}

void OperatorRig::enter_pin(const std::string& pin) {
    for (const char digit : pin) {
        if (digit == '0') press(KeyRole::down);
        for (int i = 0; i < digit - '0'; ++i) press(KeyRole::up);
        press(KeyRole::select);
    }
    press(KeyRole::select);
}

void OperatorRig::open_menu() {
    enter();
    enter_pin("1234");
    enter_pin("1234");
    press(KeyRole::back);
    (void)heard();
}

bool OperatorRig::find(const std::string& name) {
    const std::size_t count = screen().items.size();
    for (std::size_t i = 0; i < count; ++i) {
        const SpokenScreen now = screen();
        if (now.focus && now.items[*now.focus].name == name) return true;
        press(KeyRole::down);
    }
    ADD_FAILURE() << "no '" << name << "' on '" << screen().title << "'";
    return false;
}

bool OperatorRig::open(std::initializer_list<const char*> names) {
    for (const char* name : names) {
        if (!find(name)) return false;
        press(KeyRole::select);
    }
    return true;
}

std::string OperatorRig::heard() {
    return std::exchange(heard_, "");
}

}  // namespace touchline
