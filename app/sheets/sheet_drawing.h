// A sheet as a file for a printer: PDF with all pages, or SVG with the drawing.
// Threads: any, each call by itself.
#pragma once

#include "app/sheets/tactile_sheet.h"
#include "config/types/result.h"

#include <cstddef>
#include <string>
#include <vector>

namespace touchline {

/// One page each, true to size. Holds the title, and neither a date nor a name of a person. Fails
/// with one line if the drawing library has no memory.
[[nodiscard]] Result<std::vector<std::byte>> pdf_of(const TactileSheet& sheet,
                                                    const std::string& title);

/// One page in millimetres: SVG has no pages.
[[nodiscard]] Result<std::vector<std::byte>> svg_of(const PaperPage& page);

}  // namespace touchline
