#include "app/decode/page_order.h"

#include "app/decode/page.h"
#include "app/decode/signature.h"

#include <charconv>

namespace touchline {
namespace {

constexpr int least_dpi = 30;
constexpr int most_dpi = 600;

/// The whole text is a number in these bounds.
bool read_number(const std::string& text, int least, int most, int& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && number >= least &&
           number <= most;
}

}  // namespace

WorkerKind kind_of(std::span<const std::byte> bytes) {
    const FileFormat format = format_of(bytes);
    const bool is_drawn = format == FileFormat::svg || format == FileFormat::pdf;
    return is_drawn ? WorkerKind::document : WorkerKind::raster;
}

std::string program_for(WorkerKind kind) {
    return kind == WorkerKind::document ? "touchline-decode-document" : "touchline-decode";
}

std::vector<std::string> arguments_of(const PageOrder& order) {
    return {std::to_string(order.page), std::to_string(order.dpi)};
}

Result<PageOrder> order_of(std::span<const std::string> arguments) {
    PageOrder order;
    const bool is_read = arguments.size() == 2 &&
                         read_number(arguments[0], 1, max_pages, order.page) &&
                         read_number(arguments[1], least_dpi, most_dpi, order.dpi);
    if (!is_read) return failure("not what the kiosk starts it with");
    return order;
}

}  // namespace touchline
