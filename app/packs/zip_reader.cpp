#include "app/packs/zip_reader.h"

#include "app/packs/pack_limits.h"
#include "app/packs/plain_names.h"
#include "app/packs/zip_directory.h"

#include <algorithm>
#include <map>
#include <memory>

#include <archive.h>
#include <archive_entry.h>

namespace touchline {
namespace {

struct CloseArchive {
    void operator()(archive* opened) const { archive_read_free(opened); }
};

using Archive = std::unique_ptr<archive, CloseArchive>;

/// Exactly the bytes that the list claims: one more is a lie, and the beginning of a zip bomb.
PackResult<std::vector<std::byte>> contents(archive* opened, const ZipMember& member) {
    std::vector<std::byte> bytes(member.bytes);
    std::size_t got = 0;
    while (got < bytes.size()) {
        const auto count = archive_read_data(opened, bytes.data() + got, bytes.size() - got);
        if (count <= 0) return refusal({FindingKind::damaged_zip, member.name});
        got += static_cast<std::size_t>(count);
    }
    // The checksum is compared where the bytes end.
    std::byte more{};
    if (archive_read_data(opened, &more, 1) != 0)
        return refusal({FindingKind::damaged_zip, member.name});
    return bytes;
}

/// Removes the names of members that were read from `wanted`.
PackResult<std::vector<PackFile>> read_members(archive* opened,
                                               std::map<std::string, ZipMember>& wanted) {
    std::vector<PackFile> files;
    archive_entry* entry = nullptr;
    for (;;) {
        const int status = archive_read_next_header(opened, &entry);
        if (status == ARCHIVE_EOF) return files;
        if (status != ARCHIVE_OK && status != ARCHIVE_WARN)
            return refusal({FindingKind::damaged_zip});
        const char* const name = archive_entry_pathname(entry);
        const auto found = name == nullptr ? wanted.end() : wanted.find(name);
        if (found == wanted.end()) continue;
        if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_is_encrypted(entry) != 0)
            return refusal({FindingKind::no_file, found->first});
        auto bytes = contents(opened, found->second);
        if (!bytes) return refusal(bytes.error());
        files.push_back({found->first, std::move(*bytes)});
        wanted.erase(found);
    }
}

}  // namespace

PackResult<std::vector<PackFile>> files_in_zip(std::span<const std::byte> zip) {
    const auto members = zip_members(zip);
    if (!members) return refusal(members.error());
    std::map<std::string, ZipMember> wanted;
    for (const ZipMember& member : *members) wanted.emplace(member.name, member);
    const Archive opened(archive_read_new());
    const bool is_open =
        opened != nullptr && archive_read_support_format_zip_seekable(opened.get()) == ARCHIVE_OK &&
        archive_read_open_memory(opened.get(), zip.data(), zip.size()) == ARCHIVE_OK;
    if (!is_open) return refusal({FindingKind::damaged_zip});
    auto files = read_members(opened.get(), wanted);
    if (!files) return files;
    if (!wanted.empty()) return refusal({FindingKind::damaged_zip, wanted.begin()->first});
    for (const PackFile& file : *files)
        if (const auto trouble = trouble_with_file(file.name, file.bytes))
            return refusal({*trouble, file.name});
    std::sort(files->begin(), files->end(),
              [](const PackFile& a, const PackFile& b) { return a.name < b.name; });
    return files;
}

}  // namespace touchline
