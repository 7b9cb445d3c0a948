// Runs a fuzz target on every input of its corpus, in order, if libFuzzer is not linked.
#include <cstdint>
#include <cstdio>
#include <vector>

#include <archive.h>
#include <archive_entry.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

/// Returns true if every input of `opened` was read whole; `count` is the number that the target
/// got.
bool replay(archive* opened, std::size_t& count) {
    archive_entry* entry = nullptr;
    int status = ARCHIVE_OK;
    while ((status = archive_read_next_header(opened, &entry)) == ARCHIVE_OK) {
        // A separate block of exactly this size lets the sanitizers see any access beyond its end.
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(archive_entry_size(entry)));
        if (archive_read_data(opened, bytes.data(), bytes.size()) !=
            static_cast<la_ssize_t>(bytes.size())) {
            return false;
        }
        (void)LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        ++count;
    }
    return status == ARCHIVE_EOF && count > 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    archive* const opened = archive_read_new();
    archive_read_support_format_tar(opened);
    archive_read_support_filter_xz(opened);
    std::size_t count = 0;
    const bool is_whole =
        archive_read_open_filename(opened, argv[1], 65536) == ARCHIVE_OK && replay(opened, count);
    const char* const why = archive_error_string(opened);
    if (!is_whole) std::fprintf(stderr, "%s: %s\n", argv[1], why == nullptr ? "no input" : why);
    archive_read_free(opened);
    std::printf("%zu inputs replayed\n", count);
    return is_whole ? 0 : 1;
}
