#include "app/decode/page_order.h"

#include "app/decode/page.h"
#include "app/decode/signature.h"

#include <charconv>

namespace touchline {
namespace {

constexpr int least_dpi = 30;
constexpr int most_dpi = 600;

/// Reads the text as a number within these bounds.
bool read_number(const std::string& text, int least, int most, int& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number >= least &&
           number <= most;
}

}  // namespace

WorkerKind kind_of(std::span<const std::byte> bytes) {
    switch (format_of(bytes)) {
        case FileFormat::svg:
        case FileFormat::pdf:
            return WorkerKind::document;
        case FileFormat::heif:
            return WorkerKind::heif;
        default:
            return WorkerKind::raster;
    }
}

std::string program_for(WorkerKind kind) {
    switch (kind) {
        case WorkerKind::document:
            return "touchline-decode-document";
        case WorkerKind::heif:
            return "touchline-decode-heif";
        default:
            return "touchline-decode";
    }
}

std::vector<std::string> arguments_of(const DecodeWork& work) {
    return {std::to_string(static_cast<int>(work.kind)), std::to_string(work.order.page),
            std::to_string(work.order.dpi)};
}

Result<DecodeWork> work_in(std::span<const std::string> arguments) {
    DecodeWork work;
    int kind = 0;
    const bool is_read = arguments.size() == 3 &&
                         read_number(arguments[0], 0, worker_kind_count - 1, kind) &&
                         read_number(arguments[1], 1, max_pages, work.order.page) &&
                         read_number(arguments[2], least_dpi, most_dpi, work.order.dpi);
    if (!is_read) return failure("not what the kiosk starts it with");
    work.kind = static_cast<WorkerKind>(kind);
    return work;
}

}  // namespace touchline
