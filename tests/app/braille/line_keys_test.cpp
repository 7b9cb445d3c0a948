#include "app/braille/line_keys.h"

#include <array>

#include <brlapi_constants.h>
#include <brlapi_keycodes.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace touchline {
namespace {

std::optional<LineKey> of_command(std::uint64_t code) {
    return line_key_of(BRLAPI_KEY_TYPE_CMD | code);
}

TEST(LineKeys, HA3_TheKeysThatEveryDisplayHasAreTheSixRolesAndTwoPages) {
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_LNUP), LineKey(KeyRole::up));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_LNDN), LineKey(KeyRole::down));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_TOP), LineKey(KeyRole::back));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_HOME), LineKey(KeyRole::repeat));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_BOT), LineKey(KeyRole::help));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_FWINLT), LineKey(LineTurn::back));
    EXPECT_EQ(of_command(BRLAPI_KEY_CMD_FWINRT), LineKey(LineTurn::on));
    for (std::uint64_t cell = 0; cell < 80; ++cell)
        EXPECT_EQ(of_command(BRLAPI_KEY_CMD_ROUTE + cell), LineKey(KeyRole::select)) << cell;
}

TEST(LineKeys, ABrailleKeyboardsKeysDoAsTheySay) {
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_UP), LineKey(KeyRole::up));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_DOWN), LineKey(KeyRole::down));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_LINEFEED), LineKey(KeyRole::select));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_ESCAPE), LineKey(KeyRole::back));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_FUNCTION), LineKey(KeyRole::help));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_LEFT), LineKey(LineTurn::back));
    EXPECT_EQ(line_key_of(BRLAPI_KEY_SYM_RIGHT), LineKey(LineTurn::on));
}

/// What would change brltty itself, or the kernel's terminals, means nothing here.
TEST(LineKeys, NothingOfBrlttysOwnIsAKeyOfTheKiosk) {
    constexpr std::array<std::uint64_t, 8> brlttys{
        BRLAPI_KEY_CMD_PREFMENU,      BRLAPI_KEY_CMD_PREFSAVE,   BRLAPI_KEY_CMD_FREEZE,
        BRLAPI_KEY_CMD_SWITCHVT_NEXT, BRLAPI_KEY_CMD_RESTARTBRL, BRLAPI_KEY_CMD_PASTE,
        BRLAPI_KEY_CMD_NOOP,          BRLAPI_KEY_CMD_OFFLINE};
    for (const std::uint64_t code : brlttys) EXPECT_FALSE(of_command(code)) << code;
    EXPECT_FALSE(of_command(BRLAPI_KEY_CMD_SWITCHVT + 3));
    EXPECT_FALSE(of_command(BRLAPI_KEY_CMD_PASSDOTS + 1));
    EXPECT_FALSE(line_key_of('a'));
}

RC_GTEST_PROP(LineKeys, FlagsDoNotChangeAKey, (std::uint64_t code)) {
    RC_ASSERT(line_key_of(code) == line_key_of(code & ~BRLAPI_KEY_FLAGS_MASK));
}

}  // namespace
}  // namespace touchline
