#include "app/cli/commands.h"
#include "app/documents/models/networks.h"

#include <istream>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace touchline {
namespace {

std::string origin(const Network& network) {
    if (network.package.empty()) return fmt::format("trained for Touchline, {}", network.version);
    return fmt::format("from the npm package {} {}", network.package, network.version);
}

void describe(const Network& network, std::ostream& out) {
    fmt::print(out, "{}: {}\n  {}, licence {}\n  {}\n  looks at {}; {:.1f} MB\n", network.name,
               network.job, origin(network), network.licence, network.note, network.input,
               static_cast<double>(network.bytes) / 1e6);
}

std::string whereabouts(const Network& network) {
    if (network.ships) return "comes with Touchline: " + installed_file(network).string();
    if (is_installed(network)) return "installed here: " + installed_file(network).string();
    return fmt::format("not here: touchline models get {}", network.name);
}

Result<void> list_networks(std::ostream& out) {
    for (const Network& network : networks()) {
        describe(network, out);
        fmt::print(out, "  {}\n", whereabouts(network));
    }
    return {};
}

Result<void> check_networks(std::ostream& out) {
    for (const Network& network : networks()) {
        if (!network.ships && !is_installed(network)) {
            fmt::print(out, "{}: not installed here\n", network.name);
            continue;
        }
        const auto bytes = read_network(network);
        if (!bytes) return tl::unexpected(bytes.error());
        fmt::print(out, "{}: whole, in {}\n", network.name, installed_file(network).string());
    }
    return {};
}

bool agrees(std::istream& in, std::ostream& out) {
    out << "Write yes to get it under this licence: " << std::flush;
    std::string answer;
    std::getline(in, answer);
    return answer == "yes";
}

Result<void> get_one(const ModelsCommandOptions& options, std::istream& in, std::ostream& out) {
    const Network* const network = network_named(options.name);
    if (network == nullptr)
        return failure(options.name +
                       ": there is no such network; 'touchline models list' says which there are");
    const auto here = read_network(*network);
    if (here) {
        fmt::print(out, "{} is installed already.\n", network->name);
        return {};
    }
    if (network->ships) return tl::unexpected(here.error());
    describe(*network, out);
    if (!options.is_agreed && !agrees(in, out))
        return failure("nothing was got; everything else works without it");
    return get_network(*network).map(
        [&out, network] { fmt::print(out, "{} is installed.\n", network->name); });
}

}  // namespace

Result<void> run_models(const ModelsCommandOptions& options, std::istream& in, std::ostream& out) {
    switch (options.action) {
        case ModelsAction::list:
            return list_networks(out);
        case ModelsAction::check:
            return check_networks(out);
        case ModelsAction::get:
            return get_one(options, in, out);
    }
    return {};
}

}  // namespace touchline
