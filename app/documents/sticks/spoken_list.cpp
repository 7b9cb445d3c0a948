#include "app/documents/sticks/spoken_name.h"
#include "config/types/groups.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include <unicode/bytestream.h>
#include <unicode/normalizer2.h>

namespace touchline {
namespace {

using Rows = std::vector<std::size_t>;

/// Equal for all texts that a voice says alike, whatever their capitals and however their accents
/// are written.
std::string folded(const std::string& text) {
    UErrorCode error = U_ZERO_ERROR;
    const icu::Normalizer2* const folding = icu::Normalizer2::getNFKCCasefoldInstance(error);
    std::string key;
    icu::StringByteSink<std::string> sink(&key);
    if (U_SUCCESS(error) != 0) folding->normalizeUTF8(0, text, sink, nullptr, error);
    if (U_FAILURE(error) != 0) std::abort();  // an installation without ICU's tables
    return key;
}

class Telling {
  public:
    Telling(std::span<const std::string> names, std::span<const Language> languages)
        : names_(names), languages_(languages), forms_(names.size()) {}

    std::vector<NameForm> forms() {
        const std::vector<Rows> groups = alike();
        if (groups.empty()) return std::move(forms_);
        for (const Rows& group : groups) tell_apart(group);
        for (const Rows& group : alike()) {
            int number = 0;
            for (const std::size_t row : group) forms_[row].number = ++number;
        }
        return std::move(forms_);
    }

  private:
    [[nodiscard]] std::string sound_of(std::size_t row, const Language& language) const {
        return folded(spoken_name(names_[row], language, forms_[row]));
    }

    [[nodiscard]] bool are_apart(const Rows& rows) const {
        return std::ranges::all_of(languages_, [&](const Language& language) {
            std::set<std::string> sounds;
            return std::ranges::all_of(rows, [&](std::size_t row) {
                return sounds.insert(sound_of(row, language)).second;
            });
        });
    }

    /// The groups of rows that sound alike in one of the languages. Rows that sound like a member
    /// of a group in another language belong to it too.
    [[nodiscard]] std::vector<Rows> alike() const {
        Groups groups(names_.size());
        for (const Language& language : languages_) {
            std::map<std::string, std::size_t> first;
            for (std::size_t row = 0; row < names_.size(); ++row)
                groups.join(first.try_emplace(sound_of(row, language), row).first->second, row);
        }
        std::map<std::size_t, Rows> all;
        for (std::size_t row = 0; row < names_.size(); ++row)
            all[groups.first_of(row)].push_back(row);
        std::vector<Rows> several;
        for (auto& [first, group] : all)
            if (group.size() > 1) several.push_back(std::move(group));
        return several;
    }

    /// Uses the plainest detail that tells all of them apart; the whole name if none does.
    void tell_apart(const Rows& rows) {
        for (const NameDetail detail :
             {NameDetail::precise, NameDetail::with_ending, NameDetail::whole}) {
            for (const std::size_t row : rows) forms_[row].detail = detail;
            if (are_apart(rows)) return;
        }
    }

    std::span<const std::string> names_;
    std::span<const Language> languages_;
    std::vector<NameForm> forms_;
};

void add(std::string& text, const std::string& sentences) {
    if (!text.empty()) text += ' ';
    text += sentences;
}

/// One sentence per reason about folders and files, because each has another remedy.
void add_remedies(std::string& text, const StickRest& rest, const Language& language) {
    if (rest.office_files > 0) {
        add(text, language.counted("stick", "{0} office file cannot be felt. Bring it as a PDF.",
                                   "{0} office files cannot be felt. Bring them as PDFs.",
                                   rest.office_files));
    }
    const auto say = [&](const char* english) { add(text, language.text("stick", english)); };
    static_assert(deepest_folder == 8);  // as the sentence says
    if (rest.has_deeper)
        say("Folders within eight others were left out. Put their files nearer to the top.");
    if (rest.has_unreadable)
        say("Some folders could not be read. Copy their files to another USB stick.");
    if (rest.is_cut_short)
        say("There was no time for all folders. Put other files outside of all folders.");
}

}  // namespace

std::vector<NameForm> spoken_forms(std::span<const std::string> names,
                                   std::span<const Language> languages) {
    return Telling(names, languages).forms();
}

std::string words_of(const StickRest& rest, std::size_t listed, const Language& language) {
    std::string text;
    if (rest.not_listed > 0) {
        add(text, language.text(
                      "stick", "The list has {0} files of {1}. For others, bring fewer at a time.",
                      {std::to_string(listed), std::to_string(listed + rest.not_listed)}));
    }
    add_remedies(text, rest, language);
    return text;
}

std::string nothing_words(const StickRest& rest, const Language& language) {
    std::string text = language.text(
        "stick", "There is no picture or PDF on the USB stick. Put some on it and bring it again.");
    add_remedies(text, rest, language);
    return text;
}

}  // namespace touchline
