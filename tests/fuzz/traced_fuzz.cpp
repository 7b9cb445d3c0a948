// Any answer of a tracing worker gives a sound map or one clear line; the bytes of its lines lie
// within the answer.
#include "app/documents/trace/traced.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace {

bool is_one_line(const std::string& line) {
    return !line.empty() && line.find('\n') == std::string::npos;
}

bool is_harmless(const std::string& report) {
    return std::ranges::none_of(report,
                                [](char c) { return c == '\x1b' || c == '\0' || c == '\x7f'; });
}

bool is_sound(const touchline::TracedMap& traced) {
    const auto pixels = static_cast<std::size_t>(traced.edges.width) *
                        static_cast<std::size_t>(traced.edges.height);
    return !traced.map.outlines.empty() && traced.warning.find('\n') == std::string::npos &&
           is_harmless(traced.report) && traced.edges.grey.size() == pixels;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    const auto traced = touchline::traced_of(bytes);
    if (!traced && !is_one_line(traced.error().line)) abort();
    if (traced && traced->map && !is_sound(*traced->map)) abort();
    if (traced && !traced->map && !is_one_line(traced->map.error().line)) abort();
    if (touchline::lines_in(bytes).size() > size) abort();
    return 0;
}
