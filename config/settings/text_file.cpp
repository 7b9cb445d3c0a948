#include "config/settings/text_file.h"

#include <fstream>

namespace touchline {

Result<std::string> read_settings_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return failure("cannot read " + file.string());
    std::string text(largest_settings_bytes + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (in.bad()) return failure("cannot read " + file.string());
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > largest_settings_bytes)
        return failure(file.string() + " is larger than 1 MB");
    return text;
}

}  // namespace touchline
