#include "app/cli/models_command.h"

#include "app/models/getting.h"
#include "app/models/networks.h"

#include <istream>
#include <ostream>

#include <fmt/format.h>
#include <fmt/ostream.h>

namespace touchline {
namespace {

void describe(const Network& network, std::ostream& out) {
    fmt::print(out,
               "{}: {}\n  from the npm package {} {}, licence {}\n  {}\n  looks at {}; {} MB\n",
               network.name, network.job, network.package, network.version, network.licence,
               network.note, network.input, network.bytes / 1'000'000);
}

Result<void> list_networks(std::ostream& out) {
    for (const Network& network : networks()) {
        describe(network, out);
        fmt::print(out, "  {}\n",
                   is_installed(network)
                       ? fmt::format("installed here: {}", installed_file(network).string())
                       : fmt::format("not here: touchline models get {}", network.name));
    }
    return {};
}

Result<void> check_networks(std::ostream& out) {
    for (const Network& network : networks()) {
        if (!is_installed(network)) {
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
    if (read_network(*network)) {
        fmt::print(out, "{} is installed already.\n", network->name);
        return {};
    }
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
