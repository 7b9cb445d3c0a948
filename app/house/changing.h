// Several files and folders changed at once: all or nothing, also when the power goes in between.
//
// What is new is written beside its place. Then one file is put in place, which lists the moves:
// from there on the change has happened, and whoever comes next finishes it (finish_change()).
// Before, nothing has. What was before lies beside too, until the next change.
// Threads: any; calls wait for the disk and for each other, also those of other processes.
#pragma once

#include "app/house/change_lists.h"
#include "app/house/places.h"
#include "config/types/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchline {

/// A file of a folder that is new, or of none: the file itself.
struct NewBytes {
    std::string name;  // "voices/sail.ogg"; empty: the file itself
    std::span<const std::byte> bytes;
};

/// What is to be at ROOT/NAME: a file, or a folder with these files.
struct NewThing {
    HouseRoot root = HouseRoot::settings;
    std::string name;  // of one part, without a dot at its beginning
    std::vector<NewBytes> files;
};

/// The record's file. It is put in place last of all: whoever watches it sees what changed whole.
[[nodiscard]] std::filesystem::path change_record_file(const HousePlaces& places);

/// Nothing if no bundle was applied. Fails with one line if the file cannot be used.
[[nodiscard]] Result<std::optional<ChangeRecord>> read_change_record(const HousePlaces& places);

/// Finishes a change that was begun and listed, and removes what one that was not has left. Does
/// nothing on a kiosk that knows no house. To be called before the files are used.
[[nodiscard]] Result<void> finish_change(const HousePlaces& places);

/// Puts all in place, and records the change; if there is nothing, only that it is this late.
/// `judge` is asked while no other call can change anything, once all that is new is written
/// beside, which takes long; where it fails, nothing is changed. Fails with one line, and then
/// nothing is changed, but for a disk that breaks in the midst: the next call finishes it.
[[nodiscard]] Result<void> change(
    const HousePlaces& places, const std::vector<NewThing>& things, std::int64_t made_s,
    const std::function<Result<void>()>& judge = [] { return Result<void>{}; });

/// Where what was before the last change lies; nothing if this thing was not there.
[[nodiscard]] std::optional<std::filesystem::path> place_before(const HousePlaces& places,
                                                                const ChangeRecord& record,
                                                                const ChangedThing& thing);

/// True if all that was before is still there, and nothing was changed back since.
[[nodiscard]] bool can_change_back(const HousePlaces& places, const ChangeRecord& record);

/// Puts everything back as it was before this change, the last one: the same rules hold.
[[nodiscard]] Result<void> change_back(const HousePlaces& places, const ChangeRecord& record);

}  // namespace touchline
