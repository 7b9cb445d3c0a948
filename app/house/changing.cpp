#include "app/house/changing.h"

#include "app/documents/decode/files.h"
#include "app/documents/decode/one_line.h"
#include "app/house/change_lists.h"
#include "app/isolation/process/descriptor.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <ranges>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

/// Begins as all that lies beside, and so does what is left of it when the power goes meanwhile.
constexpr const char* journal_name = ".house-change";
constexpr const char* record_name = "applied.txt";
constexpr const char* lock_name = "lock";

/// One call at a time, over all processes. Held until its owner goes.
Result<Descriptor> take_lock(const HousePlaces& places) {
    std::error_code error;
    fs::create_directories(places.house, error);
    const fs::path file = places.house / lock_name;
    Descriptor lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    while (lock.is_open() && ::flock(lock.number(), LOCK_EX) != 0)
        if (errno != EINTR) lock = Descriptor();
    if (lock.is_open()) return lock;
    return failure(fmt::format("{}: cannot be written; its folder takes no files or is full",
                               one_line(file.string())));
}

// The moves. Each may have been done already, wholly or in part, before the power went.

tl::unexpected<Error> cannot_move(const fs::path& path, int number = errno) {
    const std::string why = std::generic_category().message(number);
    return failure(fmt::format("{}: cannot be put in place: {}; start the kiosk again",
                               one_line(path.string()), why));
}

/// A file stays where it is too, so that nobody finds it missing; a folder cannot.
bool set_aside(const fs::path& from, const fs::path& to) {
    std::error_code error;
    if (!fs::is_directory(fs::symlink_status(from, error)) &&
        (::link(from.c_str(), to.c_str()) == 0 || errno == EEXIST))
        return true;
    return ::rename(from.c_str(), to.c_str()) == 0;
}

/// What is not beside its place was moved before, unless the disk of both is not there.
Result<void> do_move(const HousePlaces& places, const Move& move) {
    const fs::path folder = places.folder_of(move.root);
    if (!is_there(folder)) return cannot_move(folder, ENOENT);
    const fs::path place = folder / move.name;
    const fs::path outgoing = folder / move.outgoing;
    if (move.incoming.empty()) {
        if (is_there(place) && ::rename(place.c_str(), outgoing.c_str()) != 0)
            return cannot_move(place);
        return {};
    }
    const fs::path incoming = folder / move.incoming;
    if (!is_there(incoming)) return is_there(place) ? Result<void>{} : cannot_move(place, ENOENT);
    if (is_there(place) && !set_aside(place, outgoing)) return cannot_move(place);
    if (::rename(incoming.c_str(), place.c_str()) != 0) return cannot_move(place);
    return {};
}

void flush_all(const HousePlaces& places) {
    for (std::size_t root = 0; root < house_root_words.size(); ++root)
        flush_folder(places.folder_of(static_cast<HouseRoot>(root)));
}

Result<void> do_moves(const HousePlaces& places, const std::vector<Move>& moves) {
    for (const Move& move : moves)
        if (auto done = do_move(places, move); !done) return done;
    flush_all(places);  // before the list goes, or a power cut could undo a part
    const fs::path journal = places.house / journal_name;
    if (::unlink(journal.c_str()) != 0 && errno != ENOENT) return cannot_move(journal);
    flush_folder(places.house);
    return {};
}

/// All that lies beside, but what was before the change that the record tells of.
void remove_beside(const HousePlaces& places) {
    const auto record = read_change_record(places);
    if (!record) return;  // damaged: nobody knows which of it is the way back
    const std::string kept = *record ? outgoing_name((*record)->number, "") : std::string();
    for (std::size_t root = 0; root < house_root_words.size(); ++root) {
        std::error_code error;
        std::vector<fs::path> leftovers;
        const fs::path folder = places.folder_of(static_cast<HouseRoot>(root));
        for (fs::directory_iterator it(folder, error), end; !error && it != end;
             it.increment(error)) {
            const std::string name = it->path().filename().string();
            const bool is_kept = !kept.empty() && name.starts_with(kept);
            if (name.starts_with(beside_mark) && !is_kept) leftovers.push_back(it->path());
        }
        for (const fs::path& leftover : leftovers) fs::remove_all(leftover, error);
    }
}

/// The lock must be held.
Result<void> finish(const HousePlaces& places) {
    const fs::path journal = places.house / journal_name;
    if (is_there(journal)) {
        const auto text = read_text(journal.string());
        if (!text) return tl::unexpected(text.error());
        const auto moves = moves_in(*text);
        if (!moves)
            return failure(one_line(journal.string()) +
                           ": is damaged; remove it, and apply the bundle again");
        if (auto done = do_moves(places, *moves); !done) return done;
    }
    remove_beside(places);
    return {};
}

/// Lists the moves, which makes them happen, and does them.
Result<void> carry_out(const HousePlaces& places, const std::vector<Move>& moves) {
    const std::string journal = (places.house / journal_name).string();
    const auto listed = write_whole_file(journal, journal_text(moves));
    const auto done = listed ? do_moves(places, moves) : listed;
    if (done || !listed) remove_beside(places);
    return done;
}

/// Writes what is new beside its place.
Result<Move> stage(const HousePlaces& places, const NewThing& thing, std::uint64_t number) {
    const fs::path folder = places.folder_of(thing.root);
    const Move move{thing.root, thing.name, incoming_name(number, thing.name),
                    outgoing_name(number, thing.name)};
    for (const NewBytes& file : thing.files) {
        const fs::path path =
            file.name.empty() ? folder / move.incoming : folder / move.incoming / file.name;
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (auto written = write_whole_file(path.string(), file.bytes); !written)
            return tl::unexpected(written.error());
    }
    flush_folder(folder);
    return move;
}

Result<std::vector<Move>> stage_all(const HousePlaces& places, const std::vector<NewThing>& things,
                                    std::uint64_t number) {
    std::vector<Move> moves;
    for (const NewThing& thing : things) {
        auto move = stage(places, thing, number);
        if (!move) return tl::unexpected(move.error());
        moves.push_back(std::move(*move));
    }
    return moves;
}

std::optional<fs::path> record_before(const HousePlaces& places, const ChangeRecord& record) {
    const fs::path file = places.house / outgoing_name(record.number, record_name);
    return is_there(file) ? std::optional(file) : std::nullopt;
}

/// A bundle that changes nothing leaves the way back as it is.
Result<void> become_later(const HousePlaces& places, ChangeRecord record, std::int64_t made_s) {
    if (made_s <= record.made_s) return {};
    record.made_s = made_s;
    return write_whole_file(change_record_file(places).string(), record_text(record));
}

}  // namespace

fs::path change_record_file(const HousePlaces& places) {
    return places.house / record_name;
}

Result<std::optional<ChangeRecord>> read_change_record(const HousePlaces& places) {
    const fs::path file = change_record_file(places);
    if (!is_there(file)) return std::optional<ChangeRecord>();
    const auto text = read_text(file.string());
    if (!text) return tl::unexpected(text.error());
    auto record = record_in(*text);
    if (!record)
        return failure(one_line(file.string()) +
                       ": is damaged; remove it, and apply the newest bundle again");
    return record;
}

Result<void> finish_change(const HousePlaces& places) {
    if (!is_there(places.house)) return {};
    const auto lock = take_lock(places);
    return lock ? finish(places) : tl::unexpected(lock.error());
}

Result<void> change(const HousePlaces& places, const std::vector<NewThing>& things,
                    std::int64_t made_s, const std::function<Result<void>()>& judge) {
    for (const NewThing& thing : things)
        if (!is_listed_name(thing.name))
            return failure(one_line(thing.name) + ": give this file a name without blanks");
    const auto lock = take_lock(places);
    if (!lock) return tl::unexpected(lock.error());
    if (auto done = finish(places); !done) return done;
    const auto before = read_change_record(places);
    if (!before) return tl::unexpected(before.error());
    if (things.empty() && *before) {
        const auto judged = judge();
        return judged ? become_later(places, **before, made_s) : judged;
    }
    ChangeRecord record{*before ? (*before)->number + 1 : 1, made_s, {}};
    for (const NewThing& thing : things)
        record.things.push_back(
            {thing.root, thing.name, is_there(places.folder_of(thing.root) / thing.name)});
    const std::string text = record_text(record);
    std::vector<NewThing> all = things;
    all.push_back({HouseRoot::house, record_name, {{"", std::as_bytes(std::span(text))}}});
    const auto moves = stage_all(places, all, record.number);
    const auto judged = moves ? judge() : tl::unexpected(moves.error());
    if (judged) return carry_out(places, *moves);
    remove_beside(places);
    return judged;
}

std::optional<fs::path> place_before(const HousePlaces& places, const ChangeRecord& record,
                                     const ChangedThing& thing) {
    if (!thing.was_there) return std::nullopt;
    return places.folder_of(thing.root) / outgoing_name(record.number, thing.name);
}

bool can_change_back(const HousePlaces& places, const ChangeRecord& record) {
    // Without the record before it, the kiosk would forget how old a bundle may be.
    if (record.number != 1 && !record_before(places, record)) return false;
    return std::ranges::all_of(record.things, [&](const ChangedThing& thing) {
        const auto before = place_before(places, record, thing);
        return !before || is_there(*before);
    });
}

Result<void> change_back(const HousePlaces& places, const ChangeRecord& record) {
    const auto lock = take_lock(places);
    if (!lock) return tl::unexpected(lock.error());
    if (auto done = finish(places); !done) return done;
    const auto last = read_change_record(places);
    if (!last) return tl::unexpected(last.error());
    if (*last != record || !can_change_back(places, record))
        return failure("what was before the bundle is not there any more");
    const std::uint64_t number = record.number + 1;
    std::vector<Move> moves;
    // What names something goes back before it, as it came after it.
    for (const ChangedThing& thing : std::views::reverse(record.things))
        moves.push_back({thing.root, thing.name,
                         thing.was_there ? outgoing_name(record.number, thing.name) : "",
                         outgoing_name(number, thing.name)});
    moves.push_back({HouseRoot::house, record_name,
                     record_before(places, record) ? outgoing_name(record.number, record_name) : "",
                     outgoing_name(number, record_name)});
    return carry_out(places, moves);
}

}  // namespace touchline
