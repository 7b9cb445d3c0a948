#include "app/trace/sealed_page.h"

#include "app/process/memory.h"
#include "app/sandbox/limits.h"

#include <utility>
#include <vector>

namespace touchline {
namespace {

Result<Sealed> shared(Result<Descriptor> memory) {
    if (!memory) return tl::unexpected(memory.error());
    return std::make_shared<const Descriptor>(std::move(*memory));
}

}  // namespace

Result<Sealed> sealed(const Page& page) {
    if (page.answer) return page.answer;
    return shared(answer_of(page).and_then(
        [](const std::vector<std::byte>& bytes) { return sealed_copy(bytes); }));
}

Result<Sealed> sealed_behind(ThingsInBytes things, const Page& page) {
    const auto answer = sealed(page);
    if (!answer) return answer;
    const auto bytes = map_sealed(**answer, limits_of(WorkerKind::trace).input_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    things.push_back(bytes->bytes());
    return shared(sealed_copy(joined(things)));
}

}  // namespace touchline
