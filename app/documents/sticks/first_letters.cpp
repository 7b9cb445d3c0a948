#include "app/documents/sticks/first_letters.h"

#include "app/documents/sticks/names.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <unicode/alphaindex.h>
#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/uscript.h>

namespace touchline {
namespace {

constexpr const char* other_sign = "";  // for scripts with thousands of signs

/// Gives the same label to what readers of a language take for the same letter.
class Alphabet {
  public:
    explicit Alphabet(const std::string& language) : locale_(language.c_str()) {
        UErrorCode error = U_ZERO_ERROR;
        icu::AlphabeticIndex letters(locale_, error);
        if (U_SUCCESS(error) != 0) index_.reset(letters.buildImmutableIndex(error));
        normalizer_ = icu::Normalizer2::getNFCInstance(error);
        decomposer_ = icu::Normalizer2::getNFKDInstance(error);
        collator_.reset(icu::Collator::createInstance(locale_, error));
        if (U_FAILURE(error) != 0) std::abort();  // an installation without ICU's tables
    }

    /// One label for each letter and digit of a name.
    std::vector<std::string> labels_of(std::string_view name) {
        constexpr std::size_t most = 64;
        std::vector<std::string> labels;
        const std::string stem = composed(without_ending(name));
        for (std::string_view rest = stem; !rest.empty() && labels.size() < most;) {
            const NameCharacter character = first_character(rest);
            rest.remove_prefix(character.bytes.size());
            if (is_letter(character.code) || is_number(character.code))
                labels.push_back(label_of(character.code));
        }
        return labels;
    }

    /// Compared as bytes, keys order the labels as the language does.
    [[nodiscard]] std::string key_of(const std::string& label) const {
        return sort_key(*collator_, label);
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
        if (const auto digit = digit_of(code)) return {static_cast<char>('0' + *digit)};
        UErrorCode error = U_ZERO_ERROR;
        const icu::UnicodeString letter(code);
        const auto* const bucket = index_->getBucket(index_->getBucketIndex(letter, error));
        std::string label;
        if (bucket != nullptr && bucket->getLabelType() == U_ALPHAINDEX_NORMAL) {
            bucket->getLabel().toUTF8String(label);
            return label;
        }
        const UScriptCode script = uscript_getScript(code, &error);
        if (script == USCRIPT_HAN || script == USCRIPT_HANGUL || !is_letter(code))
            return other_sign;
        const std::int32_t base = decomposer_->normalize(letter, error).char32At(0);
        icu::UnicodeString(u_toupper(base)).toUTF8String(label);
        return label;
    }

    icu::Locale locale_;
    std::unique_ptr<icu::AlphabeticIndex::ImmutableIndex> index_;
    const icu::Normalizer2* normalizer_ = nullptr;
    const icu::Normalizer2* decomposer_ = nullptr;
    std::unique_ptr<icu::Collator> collator_;
    std::unordered_map<std::int32_t, std::string> known_;
};

using Labels = std::vector<std::string>;

std::size_t common_length(const std::vector<Labels>& all) {
    std::size_t length = all.front().size();
    for (const Labels& labels : all) {
        const auto differing = std::ranges::mismatch(all.front(), labels).in1;
        length = std::min(length, static_cast<std::size_t>(differing - all.front().begin()));
    }
    return length;
}

bool is_digit_label(const std::string& label) {
    return label.size() == 1 && label[0] >= '0' && label[0] <= '9';
}

/// The place of a group among the others, and its kind.
struct GroupKey {
    int rank = 0;     // digits, letters, other
    std::string key;  // by the collator
    LetterKind kind = LetterKind::letters;
    std::string beginning;

    friend auto operator<=>(const GroupKey&, const GroupKey&) = default;
};

GroupKey key_of(const Labels& labels, std::size_t common, bool has_digits_in_one,
                const Alphabet& alphabet) {
    const bool is_longer = labels.size() > common;
    if (common == 0 && !is_longer) return {2, "", LetterKind::other, ""};
    const bool is_digit = is_longer && is_digit_label(labels[common]);
    if (is_digit && has_digits_in_one) return {0, "", LetterKind::digits, ""};
    std::string beginning;
    for (std::size_t i = 0; i < std::min(labels.size(), common + 1); ++i) beginning += labels[i];
    if (is_longer && labels[common].empty()) return {2, "", LetterKind::other, ""};
    return {is_digit ? 0 : 1, alphabet.key_of(beginning), LetterKind::letters, beginning};
}

}  // namespace

std::vector<LetterGroup> letter_groups(std::span<const std::string> names,
                                       std::span<const std::size_t> rows,
                                       const std::string& language) {
    if (rows.empty()) return {};
    Alphabet alphabet(language);
    std::vector<Labels> all;
    for (const std::size_t row : rows) all.push_back(alphabet.labels_of(names[row]));
    const std::size_t common = common_length(all);
    const bool has_letters = std::ranges::any_of(all, [](const Labels& labels) {
        return labels.empty() || !is_digit_label(labels.front());
    });
    const bool has_digits_in_one = common == 0 && has_letters;
    std::map<GroupKey, LetterGroup> groups;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const GroupKey key = key_of(all[i], common, has_digits_in_one, alphabet);
        LetterGroup& group = groups[key];
        group.kind = key.kind;
        group.beginning = key.beginning;
        group.rows.push_back(rows[i]);
    }
    std::vector<LetterGroup> sorted;
    for (auto& [key, group] : groups) sorted.push_back(std::move(group));
    return sorted;
}

}  // namespace touchline
