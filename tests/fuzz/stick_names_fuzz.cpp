// Any bytes give a name that can be shown, said and sorted without harm.
#include "app/documents/decode/opening.h"
#include "app/documents/sticks/first_letters.h"
#include "app/documents/sticks/listing.h"
#include "app/documents/sticks/names.h"
#include "app/documents/sticks/spoken_name.h"
#include "config/types/utf8.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace touchline {
namespace {

void demand(bool is_so) {
    if (!is_so) abort();
}

/// Demands that the text has no C0 or C1 control character and none that turns the text's
/// direction.
void demand_harmless(const std::string& text) {
    demand(is_utf8(text));
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        demand(byte >= 0x20 && byte != 0x7f);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        demand(byte != 0xc2 || next >= 0xa0);
        const auto last = i + 2 < text.size() ? static_cast<unsigned char>(text[i + 2]) : 0U;
        const bool is_turning = byte == 0xe2 && ((next == 0x80 && last >= 0xaa && last <= 0xae) ||
                                                 (next == 0x81 && last >= 0xa6 && last <= 0xa9));
        demand(!is_turning);
    }
}

}  // namespace
}  // namespace touchline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace touchline;
    static const NaturalOrder order;
    const std::string name(reinterpret_cast<const char*>(data), size);
    const std::string shown = shown_name(name);
    demand_harmless(shown);
    demand(shown.size() <= shown_columns * 4 * 4);  // four characters (a letter and three accents)
                                                    // of four bytes each
    const std::string spoken = spoken_name(name, Language());
    demand_harmless(spoken);
    demand(!spoken.empty() && spoken.size() <= spoken_characters * 4);
    demand(spoken.find_first_of("<>[]{}&%$\\/") == std::string::npos);
    demand(order.key_of(name).size() > size);
    const std::array names{name, std::string("a")};
    const std::array<std::size_t, 2> rows{0, 1};
    demand(!letter_groups(names, rows, "es").empty());
    demand(side_car_of(name).ends_with(".txt"));
    if (is_left_out(name)) return 0;
    (void)kind_of_name(name);
    return 0;
}
