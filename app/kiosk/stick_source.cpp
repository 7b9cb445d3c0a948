#include "app/kiosk/stick_source.h"

#include "app/documents/decode/one_line.h"
#include "app/documents/decode/opening.h"
#include "app/documents/sticks/first_letters.h"
#include "app/documents/sticks/import.h"
#include "app/documents/sticks/names.h"
#include "app/isolation/process/memory.h"
#include "app/kiosk/loading/kiosk_stages.h"
#include "app/kiosk/own_thread.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

namespace touchline {

namespace fs = std::filesystem;

/// One reader serves all sticks in turn, so that a process held up by a stick can be reaped later.
/// The last file read stays in memory: all pages of a document come from one reading.
/// Threads: any; one at a time reads, the others wait for it.
class StickReader {
  public:
    explicit StickReader(const std::string& import_program) : import_(import_program) {}

    [[nodiscard]] Result<StickListing, StickRefusal> list(const std::string& root);
    [[nodiscard]] Result<StickListing, StickRefusal> list_operator_files(const std::string& root);

    [[nodiscard]] Result<Mapping, StickRefusal> bytes_of(const std::string& root,
                                                         const StickEntry& entry);

    [[nodiscard]] Result<Page> open(const std::string& root, const StickEntry& entry,
                                    const PageOrder& order);

    /// Called when a stick, or its visitor, comes or goes. From now on no file of the one before is
    /// given. Never waits for a read under way.
    void forget();

  private:
    using Lister = Result<StickListing, StickRefusal> (StickImport::*)(const std::string& root);

    /// The bytes of a file, and of the text file beside it if there is one.
    struct Bytes {
        std::string root;
        StickEntry entry;
        Mapping document;
        std::optional<Mapping> side_car;
        std::uint64_t stick = 0;  // the number of its stick
    };

    using BytesPtr = std::shared_ptr<const Bytes>;

    [[nodiscard]] Result<StickListing, StickRefusal> listed(Lister lister, const std::string& root);
    [[nodiscard]] Result<Mapping, StickRefusal> mapped(const std::string& root,
                                                       const StickEntry& entry);
    [[nodiscard]] Result<BytesPtr, StickRefusal> read(const std::string& root,
                                                      const StickEntry& entry);
    [[nodiscard]] BytesPtr last_of(const std::string& root, const StickEntry& entry) const;
    void keep(const BytesPtr& bytes);
    std::optional<Mapping> side_car(const std::string& root, const StickEntry& entry);

    std::mutex mutex_;  // for import_; held while a file is read
    StickImport import_;
    std::atomic<std::uint64_t> stick_{0};
    mutable std::mutex last_mutex_;  // for last_; held only to copy or set it
    BytesPtr last_;
};

Result<StickListing, StickRefusal> StickReader::list(const std::string& root) {
    auto listing = listed(&StickImport::list, root);
    if (listing) sort_by_name(listing->entries);
    return listing;
}

Result<StickListing, StickRefusal> StickReader::list_operator_files(const std::string& root) {
    return listed(&StickImport::list_operator_files, root);
}

/// Memory can run out anywhere; the visit goes on.
Result<StickListing, StickRefusal> StickReader::listed(Lister lister, const std::string& root) {
    try {
        const std::lock_guard lock(mutex_);
        return (import_.*lister)(root);
    } catch (const std::exception&) {
        return tl::unexpected(StickRefusal::unreadable);
    }
}

Result<Mapping, StickRefusal> StickReader::bytes_of(const std::string& root,
                                                    const StickEntry& entry) {
    const std::lock_guard lock(mutex_);
    return mapped(root, entry);
}

Result<Mapping, StickRefusal> StickReader::mapped(const std::string& root,
                                                  const StickEntry& entry) {
    const auto memory = import_.read(root, entry);
    if (!memory) return tl::unexpected(memory.error());
    auto mapped = map_sealed(*memory, most_bytes_of(entry.kind));
    if (!mapped) return tl::unexpected(StickRefusal::unreadable);
    return std::move(*mapped);
}

Result<Page> StickReader::open(const std::string& root, const StickEntry& entry,
                               const PageOrder& order) {
    const std::string name = shown_name(entry.name);
    const auto bytes = read(root, entry);
    if (!bytes) return failure(sentence_of(bytes.error(), name));
    auto page = open_page((*bytes)->document.bytes(), order);
    if (!page) return failure(name + ": " + page.error().line);
    if ((*bytes)->side_car) tell(as_text((*bytes)->side_car->bytes()), page->told);
    return page;
}

void StickReader::forget() {
    ++stick_;
    const std::lock_guard lock(last_mutex_);
    last_.reset();
}

auto StickReader::last_of(const std::string& root, const StickEntry& entry) const -> BytesPtr {
    const std::lock_guard lock(last_mutex_);
    const bool is_it =
        last_ && last_->stick == stick_ && last_->root == root && last_->entry == entry;
    return is_it ? last_ : nullptr;
}

/// Keeps the bytes unless the stick has changed since.
void StickReader::keep(const BytesPtr& bytes) {
    const std::lock_guard lock(last_mutex_);
    last_ = bytes->stick == stick_ ? bytes : nullptr;
}

auto StickReader::read(const std::string& root, const StickEntry& entry)
    -> Result<BytesPtr, StickRefusal> {
    const std::lock_guard lock(mutex_);
    if (auto known = last_of(root, entry)) return known;
    const std::uint64_t stick = stick_;
    auto document = mapped(root, entry);
    if (!document) return tl::unexpected(document.error());
    auto bytes = std::make_shared<const Bytes>(
        Bytes{root, entry, std::move(*document), side_car(root, entry), stick});
    keep(bytes);
    return bytes;
}

/// Returns nothing for one that cannot be read.
std::optional<Mapping> StickReader::side_car(const std::string& root, const StickEntry& entry) {
    const auto text = import_.read_side_car(root, entry);
    if (!text) return std::nullopt;
    auto mapped = map_sealed(*text, max_side_car_bytes);
    if (!mapped) return std::nullopt;
    return std::move(*mapped);
}

namespace {

/// Office files are only counted.
bool can_be_felt(StickFileKind kind) {
    return kind == StickFileKind::picture || kind == StickFileKind::document;
}

/// Adds the file, or what the folder would offer as a stick; their folders become paths.
void add_entries(StickReader& reader, const fs::path& path, std::vector<StickEntry>& entries) {
    std::error_code error;
    if (!fs::is_directory(path, error)) {
        const std::string name = path.filename().string();
        const auto kind = kind_of_name(name);
        if (kind && can_be_felt(*kind))
            entries.push_back({*kind, path.parent_path().string(), name});
        return;
    }
    const auto listing = reader.list(path.string());
    if (!listing) return;
    for (const StickEntry& entry : listing->entries) {
        if (!can_be_felt(entry.kind)) continue;
        entries.push_back({entry.kind, (path / entry.folder).string(), entry.name});
    }
}

/// The pictures and documents among the entries, in the same order.
std::vector<FilePtr> files_of_stick(const std::shared_ptr<StickReader>& reader,
                                    const std::string& root, const StickListing& listing) {
    std::vector<FilePtr> files;
    for (const StickEntry& entry : listing.entries) {
        if (!can_be_felt(entry.kind)) continue;
        const std::string stem = fs::path(entry.name).stem().string();
        files.push_back(std::make_shared<const PictureFile>(
            PictureFile{shown_name(entry.name), shown_name(stem), "", true,
                        [reader, root, entry](const PageOrder& order) {
                            return reader->open(root, entry, order);
                        },
                        entry.name}));
    }
    return files;
}

}  // namespace

std::vector<FilePtr> files_at(const std::vector<std::string>& paths,
                              const std::string& import_program,
                              std::vector<std::string>& problems) {
    StickReader reader(import_program);
    std::vector<StickEntry> entries;
    for (const std::string& path : paths) {
        const std::size_t before = entries.size();
        add_entries(reader, path, entries);
        if (entries.size() == before)
            problems.push_back(one_line(path) + " holds no picture and no PDF; name another one");
    }
    sort_by_name(entries);
    std::vector<FilePtr> files;
    for (const StickEntry& entry : entries)
        files.push_back(file_at(fs::path(entry.folder) / entry.name));
    return files;
}

StickSource::StickSource(std::unique_ptr<StickPort> port, const std::string& import_program)
    : port_(std::move(port)), reader_(std::make_shared<StickReader>(import_program)) {}

std::optional<FilesChange> StickSource::poll(std::int64_t now_ns) {
    std::optional<FilesChange> change;
    for (const StickEvent& event : port_->poll(now_ns))
        if (auto newer = take(event)) change = std::move(newer);
    if (listing_.valid() &&
        listing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const Listed listed = listing_.get();
        if (!is_due_ && !root_.empty()) change = change_of(listed);
    }
    if (is_due_ && !listing_.valid()) {
        is_due_ = false;
        listing_ = on_own_thread([reader = reader_, root = root_] { return reader->list(root); },
                                 tl::unexpected(StickRefusal::not_started));
    }
    return change;
}

void StickSource::end_session() {
    port_->end_session();
    reader_->forget();
}

std::optional<FilesChange> StickSource::take(const StickEvent& event) {
    reader_->forget();
    is_due_ = event.news == StickNews::ready;
    root_ = is_due_ ? event.root : std::string();
    if (is_due_) return std::nullopt;
    return FilesChange{{}, event.sentence, {}, false};
}

FilesChange StickSource::change_of(const Listed& listed) const {
    if (!listed) return {{}, sentence_of(listed.error(), ""), {}, false};
    FilesChange change{files_of_stick(reader_, root_, *listed), "", listed->rest, true};
    change.rest.office_files = static_cast<int>(listed->entries.size() - change.files.size());
    return change;
}

OperatorStick::OperatorStick(const std::string& import_program)
    : reader_(std::make_shared<StickReader>(import_program)) {}

void OperatorStick::look_at(const std::string& root) {
    if (root == root_) return;
    root_ = root;
    files_.clear();
    names_.clear();
    is_due_ = !root.empty();
}

/// Drops a list of a stick that is gone by now, or that was plugged in again since.
std::string OperatorStick::take(Listed listed) {
    if (listed.root != root_ || is_due_) return {};
    if (!listed.listing) return sentence_of(listed.listing.error(), "");
    files_ = std::move(listed.listing->entries);
    for (const StickEntry& file : files_)
        names_.push_back(shown_name(fs::path(file.name).stem().string()));
    return {};
}

std::string OperatorStick::poll() {
    std::string sentence;
    const bool has_ended =
        listing_.valid() && listing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    if (has_ended) sentence = take(listing_.get());
    if (is_due_ && !listing_.valid()) {
        is_due_ = false;
        listing_ = on_own_thread(
            [reader = reader_, root = root_] {
                return Listed{root, reader->list_operator_files(root)};
            },
            Listed{root_, tl::unexpected(StickRefusal::not_started)});
    }
    return sentence;
}

std::function<Result<Mapping, StickRefusal>()> OperatorStick::reader_of(std::size_t file) const {
    return [reader = reader_, root = root_, entry = files_.at(file)] {
        return reader->bytes_of(root, entry);
    };
}

}  // namespace touchline
