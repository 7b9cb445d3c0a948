// touchline-read: reads words in a picture that another worker decoded.
#include "app/documents/decode/word_reader.h"
#include "app/documents/decode/worker_program.h"

#include <optional>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    using namespace touchline;
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto order = reading_order_in(arguments);
    if (!order) refuse_to_run(argv[0]);
    std::optional<Result<WordReader>> reader;
    run_worker_program({WorkerKind::ocr, [&] { reader.emplace(WordReader::load(*order)); },
                        [&](std::span<const std::byte> bytes) {
                            return answer_of(page_of(bytes).and_then([&](const Page& page) {
                                return reader->and_then([&page](WordReader& words) {
                                    return words.read(page.picture);
                                });
                            }));
                        }});
}
