// Any answer of a worker gives a sound page, sound words or one clear line.
#include "app/documents/decode/found_words.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace {

bool is_one_line(const std::string& line) {
    return !line.empty() && line.find('\n') == std::string::npos;
}

bool is_within(const touchline::WordBox& box, const touchline::Picture& picture) {
    return box.left < box.right && box.right <= picture.width && box.top < box.bottom &&
           box.bottom <= picture.height;
}

bool is_sound(const touchline::Page& page) {
    const auto width = static_cast<std::size_t>(page.picture.width);
    const auto height = static_cast<std::size_t>(page.picture.height);
    if (page.picture.bgr.size() != 3 * width * height) return false;
    for (const touchline::WordBox& box : page.words)
        if (!is_within(box, page.picture)) return false;
    for (const touchline::Figure& figure : page.figures)
        if (!is_within(figure.box, page.picture)) return false;
    return page.number >= 1 && page.number <= page.count;
}

bool is_sound(const touchline::FoundWords& words) {
    for (const touchline::WordBox& box : words.boxes)
        if (box.left >= box.right || box.right > words.width || box.bottom > words.height)
            return false;
    return words.labels.size() <= words.boxes.size();
}

/// Reads words for a picture of the size in the header, so that the rest is checked, too.
touchline::Result<touchline::FoundWords> words_in(const std::vector<std::uint8_t>& bytes) {
    std::int32_t width = 0;
    std::int32_t height = 0;
    if (bytes.size() >= 16) {
        std::memcpy(&width, &bytes[8], sizeof width);
        std::memcpy(&height, &bytes[12], sizeof height);
    }
    return touchline::words_of(std::as_bytes(std::span(bytes)), width, height);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<std::uint8_t> bytes(data, data + size);
    const auto page = touchline::page_of(std::as_bytes(std::span(bytes)));
    if (page ? !is_sound(*page) : !is_one_line(page.error().line)) abort();
    const auto words = words_in(bytes);
    if (words ? !is_sound(*words) : !is_one_line(words.error().line)) abort();
    return 0;
}
