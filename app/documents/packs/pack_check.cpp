#include "app/documents/packs/pack.h"
#include "app/documents/packs/plain_names.h"
#include "app/documents/packs/unpacking.h"

#include <algorithm>
#include <map>
#include <set>

namespace touchline {
namespace {

using PartsOfPictures = std::map<std::string, std::set<std::string>>;

void look_at_pictures(const Pack& pack, PartsOfPictures& parts,
                      std::vector<PackFinding>& findings) {
    for (const PackPicture& picture : pack.info.pictures) {
        const auto look = open_picture(*find_file(pack, picture.file), pack.info.languages);
        if (!look) {
            findings.push_back(look.error());
            continue;
        }
        findings.insert(findings.end(), look->findings.begin(), look->findings.end());
        if (!picture.difficulty && !look->difficulty)  // a grade in pack.toml counts first
            findings.push_back({FindingKind::no_difficulty, picture.file});
        for (const Outline& outline : look->map.outlines) parts[picture.file].insert(outline.id);
    }
}

void look_at_sounds(const Pack& pack, const PartsOfPictures& parts,
                    std::vector<PackFinding>& findings) {
    std::set<std::string> heard;
    for (const PackSound& sound : pack.info.sounds) {
        const auto found = parts.find(sound.picture);
        if (sound.says == SoundText::part && found != parts.end() &&
            !found->second.contains(sound.part))
            findings.push_back({FindingKind::no_such_part, sound.picture, 0, sound.part});
        if (!heard.insert(sound.file).second) continue;
        const auto look = open_sound(*find_file(pack, sound.file));
        if (look)
            findings.insert(findings.end(), look->findings.begin(), look->findings.end());
        else
            findings.push_back(look.error());
    }
}

void look_at_rest(const Pack& pack, std::vector<PackFinding>& findings) {
    std::set<std::string> named{pack_table_name};
    for (const PackPicture& picture : pack.info.pictures) named.insert(picture.file);
    for (const PackSound& sound : pack.info.sounds) named.insert(sound.file);
    for (const PackFile& file : pack.files) {
        if (const auto trouble = trouble_with_file(file.name, file.bytes))
            findings.push_back({*trouble, file.name});
        else if (!named.contains(file.name) && kind_by_name(file.name) != PackFileKind::text)
            findings.push_back({FindingKind::not_named, file.name});
    }
}

}  // namespace

std::vector<PackFinding> check_pack(const Pack& pack) {
    std::vector<PackFinding> findings;
    PartsOfPictures parts;
    look_at_pictures(pack, parts, findings);
    look_at_sounds(pack, parts, findings);
    look_at_rest(pack, findings);
    std::ranges::stable_sort(findings, [](const PackFinding& a, const PackFinding& b) {
        return severity_of(a.kind) < severity_of(b.kind);
    });
    return findings;
}

std::vector<PackFinding> check_pack(const std::string& path) {
    const auto pack = read_pack(path);
    return pack ? check_pack(*pack) : std::vector<PackFinding>{pack.error()};
}

bool can_be_used(const std::vector<PackFinding>& findings) {
    return std::ranges::none_of(findings, [](const PackFinding& finding) {
        return severity_of(finding.kind) == FindingSeverity::refusal;
    });
}

}  // namespace touchline
