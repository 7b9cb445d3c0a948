// The whole of a decoder program, which the kiosk starts for one page of one file.
#pragma once

#include "app/decode/page.h"
#include "app/decode/page_order.h"

#include <cstddef>
#include <span>

namespace touchline {

struct Decoder {
    void (*prepare)() = nullptr;  // runs before the sandbox closes, reads only the system's files
    Result<Page> (*decode)(std::span<const std::byte> bytes, const PageOrder& order) = nullptr;
};

/// The main() of a decoder. Does not return.
[[noreturn]] void run_decode_program(const Decoder& decoder, int argc, char** argv);

}  // namespace touchline
