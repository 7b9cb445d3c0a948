#include "app/documents/packs/pack_making.h"

#include "app/documents/packs/curator_folder.h"
#include "app/documents/packs/curator_texts.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/spoken_map.h"
#include "app/documents/packs/unpacking.h"
#include "audio-cues/words/language.h"
#include "config/types/utf8.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace touchline {
namespace {

namespace fs = std::filesystem;

using Faults = std::vector<std::string>;

std::string told_fault(const PackFinding& finding) {
    return sentence_of(finding, Language());
}

// A picture and its texts.

/// The outlines that this part consists of: of this id, or of several pieces of a shape.
std::vector<std::size_t> outlines_of(const std::string& part, const TactileMap& map) {
    std::vector<std::size_t> exact;
    std::vector<std::size_t> pieces;
    for (std::size_t i = 0; i < map.outlines.size(); ++i) {
        const std::string& id = map.outlines[i].id;
        const bool is_piece = id.starts_with(part + '-') &&
                              number_in<int>(std::string_view(id).substr(part.size() + 1));
        if (id == part) exact.push_back(i);
        if (is_piece) pieces.push_back(i);
    }
    if (exact.empty()) return {};
    const std::string& label = map.outlines[exact.front()].label;
    for (const std::size_t piece : pieces)
        if (map.outlines[piece].label == label) exact.push_back(piece);
    return exact;
}

std::string no_part(const std::string& picture, const std::string& part, const TactileMap& map) {
    std::string known;
    int count = 0;
    for (const Outline& outline : map.outlines) {
        if (outline.id.empty() || ++count > 12) continue;
        known += (known.empty() ? "" : ", ") + outline.id;
    }
    return fmt::format("{} has no part “{}”; {}", picture, part,
                       known.empty() ? "none of its lines has an id" : "it has " + known);
}

struct ReadPicture {
    std::string file;  // in the folder
    TactileMap map;    // in the first language
    std::optional<int> difficulty;
    std::vector<MapWords> words;  // one for each language of the pack
    bool is_rewritten = false;    // an SVG without texts beside it stays as it is
};

MapWords words_of(const TactileMap& map, const std::string& language) {
    MapWords words{language, map.title, map.description, {}, {}};
    for (const Outline& outline : map.outlines) words.parts.push_back(outline.label);
    for (const Label& label : map.labels) words.labels.push_back(label.text);
    return words;
}

/// What is the same as in the first language was not translated: it stays a gap.
void leave_out_same(const MapWords& first, MapWords& words) {
    const auto leave_out = [](const std::string& same, std::string& text) {
        if (text == same) text.clear();
    };
    leave_out(first.title, words.title);
    leave_out(first.description, words.description);
    for (std::size_t i = 0; i < words.parts.size(); ++i) leave_out(first.parts[i], words.parts[i]);
    for (std::size_t i = 0; i < words.labels.size(); ++i)
        leave_out(first.labels[i], words.labels[i]);
}

std::optional<ReadPicture> read_map(const PackFile& file, const std::vector<std::string>& languages,
                                    Faults& faults) {
    ReadPicture read{file.name, {}, std::nullopt, {}, false};
    for (const std::string& language : languages) {
        auto look = open_picture(file, {language});
        if (!look) {
            faults.push_back(told_fault(look.error()));
            return std::nullopt;
        }
        read.words.push_back(words_of(look->map, language));
        if (read.words.size() > 1) {
            leave_out_same(read.words.front(), read.words.back());
            continue;
        }
        read.map = std::move(look->map);
        read.difficulty = look->difficulty;
    }
    return read;
}

std::optional<ReadPicture> read_traced(const fs::path& folder, const std::string& name,
                                       const std::vector<std::string>& languages,
                                       const PictureTracer& trace, Faults& faults) {
    auto map = trace((folder / name).string());
    if (!map) {
        const std::string path = (folder / name).string() + ": ";
        const std::string& line = map.error().line;
        faults.push_back(
            curator_fault(name, 0, line.starts_with(path) ? line.substr(path.size()) : line));
        return std::nullopt;
    }
    ReadPicture read{name, std::move(*map), std::nullopt, {}, true};
    for (const std::string& language : languages) {
        read.words.push_back(words_of(read.map, language));
        if (read.words.size() > 1) leave_out_same(read.words.front(), read.words.back());
    }
    return read;
}

/// Takes a line of the texts of a picture. Returns what is wrong with it; empty: nothing.
std::string take_line(const CuratorLine& line, MapWords& words, ReadPicture& picture) {
    const std::string key = in_small_letters(line.key);
    const bool is_description = key == "description";
    if (!is_description && line.value.size() > pack_limits.text_bytes)
        return fmt::format("“{}” is longer than {} letters; shorten it", line.key,
                           pack_limits.text_bytes);
    if (key == "title" || is_description) {
        (is_description ? words.description : words.title) = line.value;
        return {};
    }
    if (key == "difficulty") {
        picture.difficulty = number_in(std::string_view(line.value), 1, 5);
        return picture.difficulty ? "" : "the difficulty is none; write 1 (easy) to 5";
    }
    if (!key.starts_with("part "))
        return fmt::format("“{}” is not known; write title, description, difficulty or part",
                           line.key);
    const std::string part = line.key.substr(5);
    const std::vector<std::size_t> outlines = outlines_of(part, picture.map);
    for (const std::size_t i : outlines) words.parts[i] = line.value;
    return outlines.empty() ? no_part(picture.file, part, picture.map) : "";
}

// The whole folder.

/// A pack while it is being made.
class Making {
  public:
    Making(fs::path folder, const PictureTracer& trace) : folder_(std::move(folder)) {
        files_ = read_curator_folder(folder_.string(), made_.faults);
        if (files_.contains(pack_table_name)) {
            fault(pack_table_name, "this folder is a pack already; check, try or export it");
            return;
        }
        info() = curator_info(files_, folder_.string(), made_.faults);
        if (info().languages.empty()) return;
        read_pictures(trace);
        for (const auto& [name, bytes] : files_) take_file(name, bytes);
        write();
    }

    [[nodiscard]] MadePack take() { return std::move(made_); }

  private:
    PackInfo& info() { return made_.pack.info; }

    void fault(const std::string& name, std::string_view what, int line = 0) {
        made_.faults.push_back(curator_fault(name, line, what));
    }

    void read_pictures(const PictureTracer& trace) {
        for (const auto& [name, bytes] : files_) {
            if (!is_picture(name)) continue;
            if (!stems_.insert(stem_of(name)).second) {
                fault(name, "two pictures have this name; rename one of them");
                continue;
            }
            auto read = is_traced(name)
                            ? read_traced(folder_, name, info().languages, trace, made_.faults)
                            : read_map({name, bytes}, info().languages, made_.faults);
            if (read) pictures_.emplace(stem_of(name), std::move(*read));
        }
        if (stems_.empty()) fault(folder_.string(), "there is no picture in it; add one");
    }

    void take_file(const std::string& name, const std::vector<std::byte>& bytes) {
        if (is_picture(name) || name == curator_table_name) return;
        const PackFileKind kind = kind_by_name(name);
        if (kind != PackFileKind::text && kind != PackFileKind::sound)
            return fault(name, "this is no picture, text or recording; leave it out");
        const BesidePicture beside = beside_picture(name, stems_, info().languages);
        if (beside.picture.empty())
            return fault(name,
                         fmt::format("no picture is called {}; rename the file", stem_of(name)));
        const auto picture = pictures_.find(beside.picture);
        if (picture == pictures_.end()) return;  // its own fault was told
        if (kind == PackFileKind::text)
            take_texts(name, bytes, beside, picture->second);
        else
            take_sound(name, bytes, beside, picture->second);
    }

    void take_texts(const std::string& name, const std::vector<std::byte>& bytes,
                    const BesidePicture& beside, ReadPicture& picture) {
        if (!beside.part.empty())
            return fault(name, fmt::format("“{}” is none of the pack's languages; add it to {}, or "
                                           "rename the file",
                                           beside.part, curator_table_name));
        const CuratorTexts texts = curator_texts(name, bytes);
        made_.faults.insert(made_.faults.end(), texts.faults.begin(), texts.faults.end());
        picture.is_rewritten = true;
        const std::size_t language = place_of_language(beside.language);
        for (const CuratorLine& line : texts.lines) {
            const std::string wrong = take_line(line, picture.words[language], picture);
            if (!wrong.empty()) fault(name, wrong, line.line);
        }
    }

    void take_sound(const std::string& name, const std::vector<std::byte>& bytes,
                    const BesidePicture& beside, const ReadPicture& picture) {
        PackSound sound{name,
                        packed_name(beside.picture),
                        language_at(beside.language),
                        SoundText::description,
                        {}};
        if (beside.part == "title") {
            sound.says = SoundText::title;
        } else if (!beside.part.empty() && beside.part != "description") {
            sound.says = SoundText::part;
            sound.part = beside.part;
            if (outlines_of(beside.part, picture.map).empty())
                return fault(name, no_part(picture.file, beside.part, picture.map));
        }
        const auto says_same = [&sound](const PackSound& each) {
            return each.picture == sound.picture && each.language == sound.language &&
                   each.says == sound.says && each.part == sound.part;
        };
        const auto same = std::ranges::find_if(info().sounds, says_same);
        if (same != info().sounds.end())
            return fault(name, fmt::format("{} says the same; leave one of them out", same->file));
        info().sounds.push_back(std::move(sound));
        made_.pack.files.push_back({name, bytes});
    }

    [[nodiscard]] std::size_t place_of_language(const std::string& language) {
        const auto& all = info().languages;
        const auto at = std::ranges::find(all, language);
        return at == all.end() ? 0 : static_cast<std::size_t>(at - all.begin());
    }

    [[nodiscard]] std::string language_at(const std::string& language) {
        return info().languages[place_of_language(language)];
    }

    [[nodiscard]] static std::string packed_name(const std::string& picture) {
        return picture + ".svg";
    }

    void write() {
        for (const auto& [stem, picture] : pictures_) {
            const std::string svg =
                picture.is_rewritten ? spoken_map_svg(picture.map, picture.words) : std::string();
            const auto bytes = std::as_bytes(std::span(svg));
            made_.pack.files.push_back(
                {packed_name(stem), picture.is_rewritten
                                        ? std::vector<std::byte>(bytes.begin(), bytes.end())
                                        : files_.at(picture.file)});
            info().pictures.push_back({packed_name(stem), picture.difficulty});
        }
        if (!made_.faults.empty()) return;
        const std::string toml = toml_of(info());
        if (const auto whole = pack_info_of(toml); !whole) {
            PackFinding finding = whole.error();
            finding.file = curator_table_name;  // nobody has seen the other file
            finding.line = 0;
            made_.faults.push_back(told_fault(finding));
            return;
        }
        const auto bytes = std::as_bytes(std::span(toml));
        made_.pack.files.push_back({pack_table_name, {bytes.begin(), bytes.end()}});
        std::ranges::sort(made_.pack.files, {}, &PackFile::name);
    }

    fs::path folder_;
    MadePack made_;
    FolderFiles files_;
    std::set<std::string> stems_;
    std::map<std::string, ReadPicture> pictures_;
};

}  // namespace

MadePack make_pack(const std::string& folder, const PictureTracer& trace) {
    return Making(folder, trace).take();
}

}  // namespace touchline
