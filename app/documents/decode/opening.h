// Opens untrusted files for the kiosk, and reads the words in their pictures, in workers that can
// do nothing else.
// Threads: any, each call by itself; a call waits for its worker, at most its deadline.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/found_words.h"
#include "app/documents/decode/page.h"
#include "config/types/tactile_map.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace touchline {

/// A page of a document. Fails with one line: why, and what to do.
[[nodiscard]] Result<Page> open_page(std::span<const std::byte> bytes, const PageOrder& order = {});

/// The page in a worker's answer; `answer` is sealed memory. Fails as page_of() does.
[[nodiscard]] Result<Page> page_in(std::shared_ptr<const Descriptor> answer);

/// As open_page(), for a file and the text beside it (side_car_of()); errors start with its name.
[[nodiscard]] Result<Page> open_page_of(const std::string& path, const PageOrder& order = {});

/// The words in a picture, those that are credible; finding none is no error. Fails with one line:
/// why, and what follows from it. The picture holds at least one pixel. Takes up to the deadline of
/// WorkerKind::ocr, so no thread that draws or speaks should call it.
[[nodiscard]] Result<FoundWords> read_words(const Picture& picture, const ReadingOrder& order = {});

/// A longer text is no description of a picture.
constexpr std::size_t max_side_car_bytes = 65'536;

/// The name of the text that describes a file and lies beside it: "boat.txt" for "boat.jpg".
[[nodiscard]] inline std::string side_car_of(std::string_view path) {
    return std::filesystem::path(path).replace_extension(".txt").string();
}

/// The first line becomes the title, the rest the description. A single line is the description.
/// Changes nothing if the file is empty, or is no text. O(bytes).
void tell(std::string_view side_car, TactileMap& told);

}  // namespace touchline
