#include "tests/machines/sim/kiosk/kiosk_life.h"

#include "app/kiosk/loading/kiosk_stages.h"
#include "tests/machines/sim/kiosk/house.h"

#include <string>
#include <utility>
#include <vector>

namespace touchline {
namespace {

/// Makes a part, gives it to `owner` and returns a pointer to it.
template <class Part, class Owner, class... Arguments>
Part* make(Owner& owner, Arguments&&... arguments) {
    auto made = std::make_unique<Part>(std::forward<Arguments>(arguments)...);
    Part* const part = made.get();
    owner = std::move(made);
    return part;
}

/// Returns the first four only: one more item in a list would change the run of every recorded
/// seed.
const std::vector<Language>& languages_of_seeds() {
    static const std::vector<Language> all = all_languages();
    static const std::vector<Language> four(all.begin(), all.begin() + 4);
    return four;
}

}  // namespace

KioskLife::KioskLife(const KioskPlace& place) : now_s_(place.now_s) {
    KioskParts parts;
    parts.languages = languages_of_seeds();
    parts.gallery = gallery_without_workers();
    parts.profile = default_profile();
    servo = make<LineServo>(parts.servo, line, now_s_);
    sticks = make<SimFileSource>(parts.sticks);
    parts.sound = std::make_unique<HeardSound>(place.heard);
    std::unique_ptr<Executor> executor;
    jobs = make<DueJobs>(executor, now_s_, place.fate);
    parts.loader = std::make_unique<Loader>(std::make_shared<const KioskStages>(parts.profile),
                                            std::move(executor));
    std::unique_ptr<Camera> eye;
    camera = make<SimCamera>(eye);
    parts.photos = std::make_unique<PhotoCapture>(std::move(eye));
    if (place.printer != nullptr)
        parts.printer =
            std::make_unique<SheetPrinter>(place.printer->printing(), place.printer->start());
    if (place.has_braille) {
        braille = std::make_shared<ReadLine>();
        parts.braille = std::make_unique<ReadBraille>(braille);
    }
    std::vector<std::string> problems;  // a file that cannot be read is one of the faults
    parts.operator_session =
        std::make_unique<OperatorSession>(site_files_in(place.folder), parts.languages, problems);
    parts.settings = parts.operator_session->settings();
    parts.keys = parts.operator_session->keys();
    parts.minute_of_day = place.minute_of_day;
    kiosk = std::make_unique<Kiosk>(std::move(parts));
}

void KioskLife::strike(const PhysicalKey& key) {
    kiosk->change_key({key, true, false, now_s_});
    kiosk->change_key({key, false, false, now_s_});
}

}  // namespace touchline
