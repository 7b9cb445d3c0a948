#include "app/loading/page_reader.h"

#include "app/decode/words_in_picture.h"

#include <utility>

namespace touchline {

PageReader page_reader(std::shared_ptr<const std::atomic<WrittenLanguage>> language) {
    return [language = std::move(language)](const Page& page) -> std::optional<Page> {
        if (!needs_reading(page)) return std::nullopt;
        const auto found = read_words(page.picture, {{language->load()}});
        if (!found || found->labels.empty()) return std::nullopt;
        return with_words(page, *found);
    };
}

}  // namespace touchline
