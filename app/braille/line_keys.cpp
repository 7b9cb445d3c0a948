#include "app/braille/line_keys.h"

#include <algorithm>
#include <array>

#include <brlapi_constants.h>
#include <brlapi_keycodes.h>

namespace touchline {
namespace {

struct Meaning {
    std::uint64_t code;
    LineKey key;
};

constexpr std::uint64_t command(std::uint64_t code) {
    return BRLAPI_KEY_TYPE_CMD | code;
}

constexpr std::array meanings{
    Meaning{command(BRLAPI_KEY_CMD_FWINLT), LineTurn::back},
    Meaning{command(BRLAPI_KEY_CMD_FWINLTSKIP), LineTurn::back},
    Meaning{command(BRLAPI_KEY_CMD_HWINLT), LineTurn::back},
    Meaning{command(BRLAPI_KEY_CMD_PRNBWIN), LineTurn::back},
    Meaning{command(BRLAPI_KEY_CMD_FWINRT), LineTurn::on},
    Meaning{command(BRLAPI_KEY_CMD_FWINRTSKIP), LineTurn::on},
    Meaning{command(BRLAPI_KEY_CMD_HWINRT), LineTurn::on},
    Meaning{command(BRLAPI_KEY_CMD_NXNBWIN), LineTurn::on},
    Meaning{command(BRLAPI_KEY_CMD_LNBEG), LineTurn::to_first},
    Meaning{command(BRLAPI_KEY_CMD_LNEND), LineTurn::to_last},
    Meaning{BRLAPI_KEY_SYM_LEFT, LineTurn::back},
    Meaning{BRLAPI_KEY_SYM_RIGHT, LineTurn::on},
    Meaning{BRLAPI_KEY_SYM_PAGE_UP, LineTurn::back},
    Meaning{BRLAPI_KEY_SYM_PAGE_DOWN, LineTurn::on},

    Meaning{command(BRLAPI_KEY_CMD_LNUP), KeyRole::up},
    Meaning{command(BRLAPI_KEY_CMD_WINUP), KeyRole::up},
    Meaning{command(BRLAPI_KEY_CMD_PRDIFLN), KeyRole::up},
    Meaning{command(BRLAPI_KEY_CMD_PRPGRPH), KeyRole::up},
    Meaning{command(BRLAPI_KEY_CMD_MENU_PREV_ITEM), KeyRole::up},
    Meaning{BRLAPI_KEY_SYM_UP, KeyRole::up},
    Meaning{command(BRLAPI_KEY_CMD_LNDN), KeyRole::down},
    Meaning{command(BRLAPI_KEY_CMD_WINDN), KeyRole::down},
    Meaning{command(BRLAPI_KEY_CMD_NXDIFLN), KeyRole::down},
    Meaning{command(BRLAPI_KEY_CMD_NXPGRPH), KeyRole::down},
    Meaning{command(BRLAPI_KEY_CMD_MENU_NEXT_ITEM), KeyRole::down},
    Meaning{BRLAPI_KEY_SYM_DOWN, KeyRole::down},
    Meaning{command(BRLAPI_KEY_CMD_ROUTE_CURR_LOCN), KeyRole::select},
    Meaning{BRLAPI_KEY_SYM_LINEFEED, KeyRole::select},
    Meaning{command(BRLAPI_KEY_CMD_TOP), KeyRole::back},
    Meaning{command(BRLAPI_KEY_CMD_TOP_LEFT), KeyRole::back},
    Meaning{command(BRLAPI_KEY_CMD_BACK), KeyRole::back},
    Meaning{command(BRLAPI_KEY_CMD_MENU_PREV_LEVEL), KeyRole::back},
    Meaning{command(BRLAPI_KEY_CMD_GUI_BACK), KeyRole::back},
    Meaning{BRLAPI_KEY_SYM_ESCAPE, KeyRole::back},
    Meaning{BRLAPI_KEY_SYM_BACKSPACE, KeyRole::back},
    Meaning{command(BRLAPI_KEY_CMD_HOME), KeyRole::repeat},
    Meaning{command(BRLAPI_KEY_CMD_RETURN), KeyRole::repeat},
    Meaning{command(BRLAPI_KEY_CMD_SAY_LINE), KeyRole::repeat},
    Meaning{command(BRLAPI_KEY_CMD_SPEAK_CURR_LINE), KeyRole::repeat},
    Meaning{command(BRLAPI_KEY_CMD_GUI_HOME), KeyRole::repeat},
    Meaning{BRLAPI_KEY_SYM_HOME, KeyRole::repeat},
    Meaning{command(BRLAPI_KEY_CMD_BOT), KeyRole::help},
    Meaning{command(BRLAPI_KEY_CMD_BOT_LEFT), KeyRole::help},
    Meaning{command(BRLAPI_KEY_CMD_HELP), KeyRole::help},
    Meaning{command(BRLAPI_KEY_CMD_LEARN), KeyRole::help},
    Meaning{command(BRLAPI_KEY_CMD_INFO), KeyRole::help},
    Meaning{BRLAPI_KEY_SYM_FUNCTION, KeyRole::help},  // F1
    Meaning{command(BRLAPI_KEY_CMD_SAY_LOUDER), KeyRole::louder},
    Meaning{command(BRLAPI_KEY_CMD_SAY_SOFTER), KeyRole::softer},
};

}  // namespace

std::optional<LineKey> line_key_of(std::uint64_t code) {
    const std::uint64_t bare = code & (BRLAPI_KEY_TYPE_MASK | BRLAPI_KEY_CODE_MASK);
    // The argument of a routing key is its cell.
    if ((bare & ~BRLAPI_KEY_CMD_ARG_MASK) == command(BRLAPI_KEY_CMD_ROUTE)) return KeyRole::select;
    const auto* const found = std::ranges::find(meanings, bare, &Meaning::code);
    if (found == meanings.end()) return std::nullopt;
    return found->key;
}

}  // namespace touchline
