#include "app/trace/sealed_page.h"

#include "app/process/memory.h"
#include "app/sandbox/limits.h"
#include "app/trace/two_parts.h"

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

Result<Sealed> sealed_behind(std::span<const std::byte> first, const Page& page) {
    const auto answer = sealed(page);
    if (!answer) return answer;
    const auto bytes = map_sealed(**answer, limits_of(WorkerKind::trace).input_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    return shared(sealed_copy(bytes_of(TwoParts{first, bytes->bytes()})));
}

}  // namespace touchline
