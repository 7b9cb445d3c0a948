#include "app/documents/decode/opening.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/documents/decode/picture.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/worker.h"

#include <system_error>
#include <utility>

namespace touchline {
namespace {

constexpr std::size_t most_answer_bytes = std::size_t{256} << 20U;

constexpr SaidOfEnds<const char*> said_of_files{
    "the part of Touchline that opens files cannot be started safely here; have it installed anew",
    "the file takes too long to open; save it smaller or simpler",
    "the file needs too much memory; save it smaller",
    "the file is damaged or harmful; choose another one"};

/// Few pictures have a text beside them. One that cannot be read counts as missing.
void add_side_car(const std::string& path, Page& page) {
    std::error_code error;
    const std::string beside = side_car_of(path);
    const auto size = std::filesystem::file_size(beside, error);
    if (error || size > max_side_car_bytes) return;
    if (const auto text = read_text(beside)) tell(*text, page.told);
}

}  // namespace

Result<Page> open_page(std::span<const std::byte> bytes, const PageOrder& order) {
    if (bytes.empty()) return failure("the file is empty; copy it again");
    const auto input = sealed_copy(bytes);
    if (!input) return tl::unexpected(input.error());
    const WorkerKind kind = kind_of(bytes);
    auto answer =
        run_worker({companion(program_for(kind)), arguments_of({kind, order}), kind}, *input);
    if (!answer) return failure(said_of_files[answer.error()]);
    return page_in(std::make_shared<const Descriptor>(std::move(*answer)));
}

Result<Page> page_in(std::shared_ptr<const Descriptor> answer) {
    const auto bytes = map_sealed(*answer, most_answer_bytes);
    if (!bytes) return failure(said_of_files.unsafe);
    return page_of(bytes->bytes()).map([&answer](Page page) {
        page.answer = std::move(answer);
        return page;
    });
}

Result<Page> open_page_of(const std::string& path, const PageOrder& order) {
    const auto bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    auto opened = open_page(*bytes, order);
    if (!opened) return failure(one_line(path) + ": " + opened.error().line);
    add_side_car(path, *opened);
    return opened;
}

Result<Picture> read_picture(const std::string& path) {
    return open_page_of(path).map([](Page page) { return std::move(page.picture); });
}

}  // namespace touchline
