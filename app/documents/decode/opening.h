// Opens untrusted files for the kiosk, in a worker that can do nothing else.
// Threads: any, each call by itself; a call waits for its worker, at most its deadline.
#pragma once

#include "app/documents/decode/file_format.h"
#include "app/documents/decode/page.h"

#include <memory>
#include <span>
#include <string>

namespace touchline {

/// A page of a document. Fails with one line: why, and what to do.
[[nodiscard]] Result<Page> open_page(std::span<const std::byte> bytes, const PageOrder& order = {});

/// The page in a worker's answer; `answer` is sealed memory. Fails as page_of() does.
[[nodiscard]] Result<Page> page_in(std::shared_ptr<const Descriptor> answer);

/// As open_page(), for a file and the text beside it (side_car.h); errors start with its name.
[[nodiscard]] Result<Page> open_page_of(const std::string& path, const PageOrder& order = {});

}  // namespace touchline
