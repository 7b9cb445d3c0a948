#include "app/cli/commands.h"
#include "app/cli/load.h"
#include "app/documents/decode/files.h"
#include "app/documents/packs/pack.h"
#include "app/documents/packs/pack_library.h"
#include "app/documents/packs/pack_making.h"
#include "app/documents/packs/unpacking.h"
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

std::string counted(const char* what, std::size_t count) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
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

void tell_findings(const std::vector<PackFinding>& findings, std::ostream& out) {
    for (const PackFinding& finding : findings)
        out << word_for(severity_of(finding.kind)) << ": "
            << plain_line(sentence_of(finding, Language())) << '\n';
}

Result<void> check(const std::string& input, std::ostream& out) {
    const auto findings = check_pack(input);
    tell_findings(findings, out);
    if (!can_be_used(findings))
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

Result<void> make(const PackCommandOptions& options, std::ostream& out) {
    const MadePack made =
        make_pack(options.input, [](const std::string& path) { return load_map(path, true); });
    for (const std::string& fault : made.faults) out << "error: " << plain_line(fault) << '\n';
    const auto findings = made.faults.empty() ? check_pack(made.pack) : std::vector<PackFinding>();
    tell_findings(findings, out);
    if (!made.faults.empty() || !can_be_used(findings))
        return failure(
            fmt::format("{}: no pack was made; correct what is called an error", options.input));
    const auto zip = zip_of(made.pack);
    if (!zip) return failed(zip.error());
    if (const auto written = write_whole_file(options.output, *zip); !written) return written;
    out << plain_line(fmt::format("{0}: {1}, {2}; touchline pack try {0} lets you hear and feel it",
                                  options.output,
                                  counted("picture", made.pack.info.pictures.size()),
                                  counted("recording", made.pack.info.sounds.size())))
        << '\n';
    return {};
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
        case PackAction::make:
            return make(options, out);
        case PackAction::attempt:
            return import(options, out);
    }
    return {};
}

}  // namespace touchline
