#include "app/decode/words_in_picture.h"

#include "app/process/memory.h"
#include "app/process/places.h"
#include "app/sandbox/worker.h"

#include <string>

namespace touchline {
namespace {

std::string words_for(WorkerEnd end) {
    switch (end) {
        case WorkerEnd::not_started:
            return "the part of Touchline that reads words in pictures cannot be started safely "
                   "here; have it installed anew";
        case WorkerEnd::out_of_time:
            return "reading the words in the picture takes too long; it is shown without them";
        case WorkerEnd::out_of_memory:
            return "reading the words in the picture needs too much memory; it is shown without "
                   "them";
        case WorkerEnd::done:
        case WorkerEnd::crashed:
        case WorkerEnd::no_answer:
            return "the words in the picture could not be read safely; it is shown without them";
    }
    return {};
}

}  // namespace

Result<FoundWords> read_words(const Picture& picture, const ReadingOrder& order) {
    const auto input = answer_of(picture).and_then(
        [](const std::vector<std::byte>& bytes) { return sealed_copy(bytes); });
    if (!input) return tl::unexpected(input.error());
    const auto outcome =
        run_worker({companion("touchline-read"), arguments_of(order), WorkerKind::ocr}, *input);
    if (outcome.end != WorkerEnd::done) return failure(words_for(outcome.end));
    const auto answer = map_sealed(outcome.output, limits_of(WorkerKind::ocr).file_bytes);
    if (!answer) return failure(words_for(WorkerEnd::no_answer));
    return words_of(answer->bytes(), picture.width, picture.height);
}

}  // namespace touchline
