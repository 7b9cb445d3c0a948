// A curator's folder: its files, which of them belongs to which picture, and pack.txt, which tells
// what is true of the whole pack. A fault is one sentence with the file, why, and what to do.
// Threads: pure functions, except what reads the folder.
#pragma once

#include "app/documents/packs/pack.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace touchline {

using FolderFiles = std::map<std::string, std::vector<std::byte>>;

/// The files of the folder itself, without litter (plain_names.h). A fault for each name, folder,
/// link and size that no pack may have, and for what cannot be read.
[[nodiscard]] FolderFiles read_curator_folder(const std::string& folder,
                                              std::vector<std::string>& faults);

/// The name without its ending.
[[nodiscard]] std::string stem_of(const std::string& name);

/// True for a picture whose lines must be traced, by the name's ending.
[[nodiscard]] bool is_traced(const std::string& name);

/// True for these and for an SVG.
[[nodiscard]] bool is_picture(const std::string& name);

/// "boat", "de" and "sail" of "boat.de.sail.ogg".
struct BesidePicture {
    std::string picture;   // the stem of one; empty: none has such a name
    std::string language;  // empty: the first
    std::string part;      // what else is in the name; empty: nothing
};

/// The longest stem of a picture counts. O(pictures).
[[nodiscard]] BesidePicture beside_picture(const std::string& name,
                                           const std::set<std::string>& pictures,
                                           const std::vector<std::string>& languages);

/// The file that tells what is true of the whole pack: title, author, licence and languages; id
/// (else the folder's name), version (else 1), and the title in other languages ("title de").
inline constexpr const char* curator_table_name = "pack.txt";

/// Without pictures and sounds. Values are as they were written: pack_info_of() checks
/// them; but languages are good, or there are none.
[[nodiscard]] PackInfo curator_info(const FolderFiles& files, const std::string& folder,
                                    std::vector<std::string>& faults);

}  // namespace touchline
