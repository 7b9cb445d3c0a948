#include "app/cli/commands.h"
#include "app/documents/decode/files.h"
#include "app/house/bundle_making.h"
#include "app/house/bundle_plan.h"
#include "app/house/house_keys.h"
#include "app/house/joined_counters.h"
#include "app/sound/catalogues.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <chrono>
#include <ostream>

#include <fmt/chrono.h>
#include <fmt/core.h>

namespace touchline {
namespace {

tl::unexpected<Error> as_failure(const BundleError& error) {
    return failure(error.line);
}

std::string digits_in(std::string_view text) {
    std::string digits;
    for (const char c : text)
        if (c >= '0' && c <= '9') digits += c;
    return digits;
}

/// On the kiosk that makes bundles.
Result<void> give_key(const BundleCommandOptions& options, std::ostream& out) {
    const auto key = make_house_key(house_places());
    if (!key) return as_failure(key.error());
    if (!options.output.empty())
        if (const auto written = write_whole_file(options.output, key_text(*key)); !written)
            return written;
    out << "the key of this house: " << fingerprint_of(*key) << '\n';
    return {};
}

/// On the others. The person types what was read on the first one.
Result<void> take_key(const BundleCommandOptions& options, std::ostream& out) {
    const auto bytes = read_file(options.input);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto key = house_key_in(*bytes, options.input);
    if (!key) return as_failure(key.error());
    const std::string fingerprint = fingerprint_of(*key);
    if (digits_in(options.fingerprint) != digits_in(fingerprint))
        return failure(options.fingerprint.empty()
                           ? fmt::format("{}: nothing was changed; if the other kiosk tells the "
                                         "same digits, say --fingerprint \"{}\"",
                                         options.input, fingerprint)
                           : fmt::format("{}: is another key, {}; nothing was changed",
                                         options.input, fingerprint));
    const auto trusted = trust_house_key(house_places(), *key);
    if (!trusted) return as_failure(trusted.error());
    out << "this kiosk takes bundles of the key " << fingerprint << '\n';
    return {};
}

Result<void> make_one(const BundleCommandOptions& options, std::ostream& out) {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    const auto bundle = make_bundle(house_places(), now);
    if (!bundle) return as_failure(bundle.error());
    if (const auto written = write_whole_file(options.output, *bundle); !written) return written;
    const std::size_t begun_kB = (bundle->size() + 999) / 1000;
    out << plain_line(fmt::format("{}: {} kB", options.output, begun_kB)) << '\n';
    return {};
}

void tell_lines(const std::vector<std::string>& lines, std::ostream& out) {
    for (const std::string& line : lines) out << plain_line(line) << '\n';
}

/// Tells what the bundle would change; then changes it, unless that was all that was asked.
Result<void> look_or_apply(const BundleCommandOptions& options, std::ostream& out) {
    const auto bytes = read_file(options.input);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto languages = languages_in(words_folder().string());
    const HousePlaces places = house_places();
    const auto plan = plan_of_bundle(*bytes, options.input, places,
                                     languages.value_or(std::vector<std::string>{}));
    if (!plan) return as_failure(plan.error());
    const auto lines = plan_lines(*plan, Language());
    tell_lines(lines, out);
    const std::string made = fmt::format("{}: made on {:%Y-%m-%d}", options.input,
                                         fmt::gmtime(static_cast<std::time_t>(plan->made_s)));
    const bool applies = options.action == BundleAction::apply;
    if (applies)
        if (const auto applied = apply_plan(*plan, places); !applied)
            return as_failure(applied.error());
    out << plain_line(made + (lines.empty() ? "; this kiosk is as the bundle says"
                              : applies     ? "; applied, 'touchline bundle undo' leads back"
                                            : "; nothing was changed"))
        << '\n';
    if (applies && !plan->packs.empty())
        out << "its packs of pictures will be there when the kiosk next starts\n";
    return {};
}

/// Tells what would go back; then it does, if that was asked.
Result<void> look_or_go_back(const BundleCommandOptions& options, std::ostream& out) {
    const HousePlaces places = house_places();
    const auto way = find_way_back(places);
    if (!way) return as_failure(way.error());
    tell_lines(way_back_lines(*way, Language()), out);
    if (!options.is_agreed) {
        out << "nothing was changed; 'touchline bundle undo --yes' goes back, and what was set "
               "since the bundle is lost\n";
        return {};
    }
    if (const auto done = go_back(*way, places); !done) return as_failure(done.error());
    out << "this kiosk is as before the bundle\n";
    return {};
}

}  // namespace

Result<void> run_bundle(const BundleCommandOptions& options, std::ostream& out) {
    switch (options.action) {
        case BundleAction::key:
            return options.input.empty() ? give_key(options, out) : take_key(options, out);
        case BundleAction::make:
            return make_one(options, out);
        case BundleAction::check:
        case BundleAction::apply:
            return look_or_apply(options, out);
        case BundleAction::undo:
            return look_or_go_back(options, out);
    }
    return {};
}

Result<void> run_counters(const CountersCommandOptions& options) {
    std::vector<KioskCounts> kiosks;
    for (const std::string& file : options.inputs) {
        const auto text = read_text(file);
        if (!text) return tl::unexpected(text.error());
        const auto days = parse_counters(*text, file);
        if (!days) return tl::unexpected(days.error());
        kiosks.push_back({kiosk_of_file(file), *days});
    }
    return joined_counters_csv(std::move(kiosks)).and_then([&](const std::string& csv) {
        return write_whole_file(options.output, csv);
    });
}

}  // namespace touchline
