#include "app/kiosk/operator_house.h"

#include "app/documents/decode/files.h"
#include "app/house/bundle_making.h"
#include "app/house/house_keys.h"
#include "app/kiosk/own_thread.h"
#include "app/operator/settings_files.h"

#include <chrono>
#include <utility>

namespace touchline {
namespace {

namespace fs = std::filesystem;

constexpr const char* bundle_name = "house.touchline-bundle";
constexpr const char* key_name = "house.touchline-key";
constexpr const char* takes_a_moment = "This takes a moment. You hear when it is done.";

HouseNews news_of(const BundleError& error, const Language& language) {
    return {std::nullopt, {sentence_of(error.fault, language), error.line}, false};
}

HouseNews news_of(const Error& error, const Language& language) {
    return news_of(BundleError{BundleFault::disk, error.line}, language);
}

HouseNews told_of(std::string said, bool has_changed = false) {
    return {std::nullopt, {std::move(said), ""}, has_changed};
}

/// The digits of a key, a line for each group, with a blank between two: "6 3 2 9".
std::vector<std::string> digit_lines(const PublicKey& key) {
    std::vector<std::string> lines(1);
    for (const char c : fingerprint_of(key)) {
        if (c == ' ') {
            lines.emplace_back();
            continue;
        }
        if (!lines.back().empty()) lines.back() += ' ';
        lines.back() += c;
    }
    return lines;
}

}  // namespace

OperatorHouse::OperatorHouse(HousePlaces places, fs::path copies)
    : places_(std::move(places)), copies_(std::move(copies)) {}

void OperatorHouse::begin(std::function<Done()> work, const Language& language, const char* said) {
    if (work_.valid()) {
        at_once_ = told_of(language.text("bundle", "Something else is still being done. Wait."));
        return;
    }
    const Error nothing_left{"no memory or no thread is left for bundles; start the kiosk again"};
    work_ = on_own_thread(std::move(work), Done{news_of(nothing_left, language), {}});
    if (*said != '\0') at_once_ = told_of(language.text("bundle", said));
}

std::optional<HouseNews> OperatorHouse::poll() {
    if (at_once_) return std::exchange(at_once_, std::nullopt);
    const bool has_ended =
        work_.valid() && work_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (!has_ended) return std::nullopt;
    Done done = work_.get();
    looked_ = std::move(done.looked);
    return std::move(done.news);
}

void OperatorHouse::look_at(HouseFile file, std::vector<std::string> languages,
                            const Language& language) {
    begin(
        [this_places = places_, file = std::move(file), languages = std::move(languages),
         language]() -> Done {
            const auto bytes = file.read();
            if (!bytes) return {{std::nullopt, bytes.error(), false}, {}};
            if (file.is_key) {
                const auto key = house_key_in(bytes->bytes(), file.name);
                if (!key) return {news_of(key.error(), language), {}};
                return {{OperatorPlace::house_key, {}, false}, {digit_lines(*key), {}, {}, *key}};
            }
            auto plan = plan_of_bundle(bytes->bytes(), file.name, this_places, languages);
            if (!plan) return {news_of(plan.error(), language), {}};
            auto lines = plan_lines(*plan, language);
            auto kept = std::make_shared<const BundlePlan>(std::move(*plan));
            return {{OperatorPlace::bundle, {}, false},
                    {std::move(lines), std::move(kept), {}, {}}};
        },
        language);
}

void OperatorHouse::look_at_way_back(const Language& language) {
    begin(
        [places = places_, language]() -> Done {
            auto way = find_way_back(places);
            if (!way) return {news_of(way.error(), language), {}};
            auto lines = way_back_lines(*way, language);
            return {{OperatorPlace::way_back, {}, false},
                    {std::move(lines), {}, std::move(*way), {}}};
        },
        language);
}

void OperatorHouse::apply(const Language& language) {
    if (!looked_.plan) return;
    begin(
        [places = places_, plan = looked_.plan, language]() -> Done {
            const auto applied = apply_plan(*plan, places);
            if (!applied) return {news_of(applied.error(), language), {}};
            const char* const said =
                plan->packs.empty()
                    ? "The bundle is applied."
                    : "The bundle is applied. Its packs of pictures will be there when the kiosk "
                      "next starts.";
            return {told_of(language.text("bundle", said), true), {}};
        },
        language, takes_a_moment);
}

void OperatorHouse::go_back(const Language& language) {
    if (!looked_.way) return;
    begin(
        [places = places_, way = *looked_.way, language]() -> Done {
            const auto gone = touchline::go_back(way, places);
            if (!gone) return {news_of(gone.error(), language), {}};
            return {told_of(language.text("bundle", "All is as before the bundle."), true), {}};
        },
        language, takes_a_moment);
}

void OperatorHouse::trust_key(const Language& language) {
    if (!looked_.key) return;
    begin(
        [places = places_, key = *looked_.key, language]() -> Done {
            const auto trusted = trust_house_key(places, key);
            if (!trusted) return {news_of(trusted.error(), language), {}};
            return {
                told_of(language.text("bundle", "Bundles of this house are taken from now on.")),
                {}};
        },
        language);
}

void OperatorHouse::make(const Language& language) {
    begin(
        [places = places_, copies = copies_, language]() -> Done {
            using std::chrono::floor, std::chrono::seconds, std::chrono::system_clock;
            const auto bundle = make_bundle(places, floor<seconds>(system_clock::now()));
            if (!bundle) return {news_of(bundle.error(), language), {}};
            std::error_code error;
            fs::create_directories(copies, error);
            const auto written = write_whole_file((copies / bundle_name).string(), *bundle);
            if (!written) return {news_of(written.error(), language), {}};
            return {told_of(language.text("bundle",
                                          "The bundle is in the folder {0}, beside the settings.",
                                          {copies.filename().string()})),
                    {}};
        },
        language, takes_a_moment);
}

void OperatorHouse::show_key(const Language& language) {
    begin(
        [places = places_, copies = copies_, language]() -> Done {
            const auto key = make_house_key(places);
            if (!key) return {news_of(key.error(), language), {}};
            const auto kept = keep_text(copies / key_name, key_text(*key));
            if (!kept) return {news_of(kept.error(), language), {}};
            return {{OperatorPlace::own_key, {}, false}, {digit_lines(*key), {}, {}, {}}};
        },
        language);
}

}  // namespace touchline
