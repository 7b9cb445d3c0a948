#include "app/cli/commands.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/pack_library.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <ostream>
#include <string_view>

#include <fmt/core.h>

namespace touchline {
namespace {

tl::unexpected<Error> failed(const PackFinding& finding) {
    return failure(sentence_of(finding, Language()));
}

std::string_view word_for(FindingSeverity severity) {
    switch (severity) {
        case FindingSeverity::refusal:
            return "error";
        case FindingSeverity::gap:
            return "missing";
        case FindingSeverity::hint:
            return "hint";
    }
    return {};
}

Result<void> check(const std::string& input, std::ostream& out) {
    const auto findings = check_pack(input);
    for (const PackFinding& finding : findings)
        out << word_for(severity_of(finding.kind)) << ": "
            << plain_line(sentence_of(finding, Language())) << '\n';
    const auto refusals =
        std::count_if(findings.begin(), findings.end(), [](const PackFinding& finding) {
            return severity_of(finding.kind) == FindingSeverity::refusal;
        });
    if (refusals > 0)
        return failure(fmt::format("{}: cannot be used; correct what is called an error", input));
    out << plain_line(input) << ": can be used"
        << (findings.empty() ? "" : fmt::format("; {} hints for a better one", findings.size()))
        << '\n';
    return {};
}

Result<void> import(const PackCommandOptions& options, std::ostream& out) {
    const auto pack = read_pack(options.input);
    if (!pack) return failed(pack.error());
    const std::string library = options.library.empty() ? library_folder() : options.library;
    const auto folder =
        import_pack(*pack, library, options.takes_older ? OlderPack::take : OlderPack::ask);
    if (!folder) {
        const bool is_older = folder.error().kind == FindingKind::older;
        return failure(sentence_of(folder.error(), Language()) +
                       (is_older ? " with --take-older" : ""));
    }
    out << fmt::format("{} {}: installed in {}\n", pack->info.id, text_of(pack->info.version),
                       plain_line(*folder));
    return {};
}

Result<void> write(const PackCommandOptions& options) {
    const auto written = export_pack(options.input, options.output, options.image_language);
    return written ? Result<void>{} : failed(written.error());
}

}  // namespace

Result<void> run_pack(const PackCommandOptions& options, std::ostream& out) {
    switch (options.action) {
        case PackAction::check:
            return check(options.input, out);
        case PackAction::import:
            return import(options, out);
        case PackAction::write:
            return write(options);
    }
    return {};
}

}  // namespace touchline
