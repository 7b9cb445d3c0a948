#include "app/documents/sticks/first_letters.h"

#include "app/documents/sticks/names.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <unordered_map>
#include <utility>

#include <unicode/alphaindex.h>
#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/uscript.h>

namespace touchline {
namespace {

/// Gives the same label to all forms of a letter.
class Alphabet {
  public:
    Alphabet() {
        UErrorCode error = U_ZERO_ERROR;
        icu::AlphabeticIndex letters(icu::Locale::getEnglish(), error);
        if (U_SUCCESS(error) != 0) index_.reset(letters.buildImmutableIndex(error));
        normalizer_ = icu::Normalizer2::getNFCInstance(error);
        decomposer_ = icu::Normalizer2::getNFKDInstance(error);
        collator_.reset(icu::Collator::createInstance(icu::Locale::getRoot(), error));
        if (U_FAILURE(error) != 0) std::abort();  // an installation without ICU's tables
    }

    std::string first_of(std::string_view name) {
        const std::string stem = composed(without_ending(name));
        for (std::string_view rest = stem; !rest.empty();) {
            const NameCharacter character = first_character(rest);
            rest.remove_prefix(character.bytes.size());
            if (is_letter(character.code) || is_number(character.code))
                return label_of(character.code);
        }
        return {};
    }

    /// Compared as bytes, keys order the labels.
    [[nodiscard]] std::string key_of(const std::string& label) const {
        if (label.empty()) return "2";
        // The label itself tells letters apart that the language of the order does not.
        return (label == digit_letter ? '0' : '1') + sort_key(*collator_, label) + label + '\0';
    }

  private:
    [[nodiscard]] std::string composed(std::string_view name) const {
        UErrorCode error = U_ZERO_ERROR;
        const auto text =
            icu::UnicodeString::fromUTF8({name.data(), static_cast<std::int32_t>(name.size())});
        std::string stem;
        normalizer_->normalize(text, error).toUTF8String(stem);
        return stem;
    }

    const std::string& label_of(std::int32_t code) {
        const auto [at, is_new] = known_.try_emplace(code);
        if (is_new) at->second = made_label(code);
        return at->second;
    }

    [[nodiscard]] std::string made_label(std::int32_t code) const {
        if (digit_of(code)) return std::string(digit_letter);
        UErrorCode error = U_ZERO_ERROR;
        const icu::UnicodeString letter(code);
        const auto* const bucket = index_->getBucket(index_->getBucketIndex(letter, error));
        std::string label;
        if (bucket != nullptr && bucket->getLabelType() == U_ALPHAINDEX_NORMAL) {
            bucket->getLabel().toUTF8String(label);
            return label;
        }
        const UScriptCode script = uscript_getScript(code, &error);
        if (script == USCRIPT_HAN || script == USCRIPT_HANGUL || !is_letter(code)) return {};
        const std::int32_t base = decomposer_->normalize(letter, error).char32At(0);
        icu::UnicodeString(u_toupper(base)).toUTF8String(label);
        return label;
    }

    std::unique_ptr<icu::AlphabeticIndex::ImmutableIndex> index_;
    const icu::Normalizer2* normalizer_ = nullptr;
    const icu::Normalizer2* decomposer_ = nullptr;
    std::unique_ptr<icu::Collator> collator_;
    std::unordered_map<std::int32_t, std::string> known_;
};

}  // namespace

std::vector<std::string> first_letters(std::span<const std::string> names) {
    Alphabet alphabet;
    std::vector<std::string> letters;
    letters.reserve(names.size());
    for (const std::string& name : names) letters.push_back(alphabet.first_of(name));
    return letters;
}

void sort_by_name(std::vector<StickEntry>& entries) {
    Alphabet alphabet;
    const NaturalOrder order;
    std::vector<std::pair<std::string, StickEntry>> keyed;
    keyed.reserve(entries.size());
    for (StickEntry& entry : entries) {
        std::string key = alphabet.key_of(alphabet.first_of(entry.name)) + order.key_of(entry.name);
        keyed.emplace_back(std::move(key), std::move(entry));
    }
    std::ranges::stable_sort(keyed, {}, &std::pair<std::string, StickEntry>::first);
    std::ranges::transform(keyed, entries.begin(),
                           [](auto& each) { return std::move(each.second); });
}

}  // namespace touchline
