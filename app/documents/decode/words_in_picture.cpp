#include "app/documents/decode/opening.h"
#include "app/isolation/process/memory.h"
#include "app/isolation/process/places.h"
#include "app/isolation/sandbox/worker.h"

namespace touchline {
namespace {

constexpr SaidOfEnds<const char*> said_of_words{
    "the part of Touchline that reads words in pictures cannot be started safely here; have it "
    "installed anew",
    "reading the words in the picture takes too long; it is shown without them",
    "reading the words in the picture needs too much memory; it is shown without them",
    "the words in the picture could not be read safely; it is shown without them"};

}  // namespace

Result<FoundWords> read_words(const Picture& picture, const ReadingOrder& order) {
    const auto input = answer_of(picture).and_then(
        [](const std::vector<std::byte>& bytes) { return sealed_copy(bytes); });
    if (!input) return tl::unexpected(input.error());
    const auto answer =
        call_worker({companion("touchline-read"), arguments_of(order), WorkerKind::ocr}, *input);
    if (!answer) return failure(said_of_words[answer.error()]);
    return words_of(answer->bytes(), picture.width, picture.height);
}

}  // namespace touchline
