#include "app/sticks/natural_order.h"

#include <cstdint>
#include <cstdlib>
#include <vector>

#include <unicode/unistr.h>

namespace touchline {

NaturalOrder::NaturalOrder() {
    UErrorCode error = U_ZERO_ERROR;
    collator_.reset(icu::Collator::createInstance(icu::Locale::getRoot(), error));
    if (U_SUCCESS(error) != 0) collator_->setAttribute(UCOL_NUMERIC_COLLATION, UCOL_ON, error);
    if (U_FAILURE(error) != 0) std::abort();
    (void)key_of("warm 1");
}

std::string NaturalOrder::key_of(std::string_view name) const {
    const auto text =
        icu::UnicodeString::fromUTF8({name.data(), static_cast<std::int32_t>(name.size())});
    const std::int32_t bytes = collator_->getSortKey(text, nullptr, 0);
    std::string key(static_cast<std::size_t>(bytes), '\0');
    collator_->getSortKey(text, reinterpret_cast<std::uint8_t*>(key.data()), bytes);
    // The key ends with a zero byte, so names that a reader takes for equal follow by their bytes.
    return key.append(name);
}

}  // namespace touchline
