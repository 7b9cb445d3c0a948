// The names of a stick's files, which are untrusted: any bytes except NUL and '/'. Show or say only
// the results of shown_name() and of spoken_name.h; open the file only by the bytes themselves.
// The characters of a name, and the words and numbers that it divides into, are for this folder
// alone.
// Threads: pure functions; a NaturalOrder by one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <unicode/coll.h>

namespace touchline {

inline constexpr std::size_t shown_columns = 80;

/// For the screen: valid UTF-8 on one line, at most shown_columns wide (a wide character counts
/// two), with an ellipsis where it was cut. Characters that are invisible or turn the text around
/// (control, format and unassigned characters) become U+FFFD, a stray byte becomes \xNN, and a
/// letter keeps at most three accents.
[[nodiscard]] std::string shown_name(std::string_view name);

/// Compared as bytes, keys order texts as the collator does; a key ends with a zero byte. O(n).
[[nodiscard]] std::string sort_key(const icu::Collator& collator, std::string_view text);

/// Construct it before the sandbox closes: its tables come with the library, but may be read late.
class NaturalOrder {
  public:
    /// The order that all languages share. Aborts if the library has no tables, because then the
    /// installation is broken.
    NaturalOrder();

    /// Compared as bytes, keys order the names; no two names have the same key. Stray bytes stand
    /// for U+FFFD. O(n), at most some 20 bytes per byte.
    [[nodiscard]] std::string key_of(std::string_view name) const;

  private:
    std::unique_ptr<icu::Collator> collator_;
};

/// The most accents kept on one letter.
inline constexpr int most_piled_marks = 3;

/// One character of a name, or one byte that is not part of a character.
struct NameCharacter {
    std::string_view bytes;
    std::int32_t code = -1;  // -1: no character
};

/// The text must not be empty.
[[nodiscard]] NameCharacter first_character(std::string_view text);

/// True for control, format, private and unassigned characters, and line separators.
[[nodiscard]] bool is_invisible(std::int32_t code);

[[nodiscard]] bool is_mark(std::int32_t code);
[[nodiscard]] bool is_letter(std::int32_t code);
[[nodiscard]] bool is_capital(std::int32_t code);

/// True for a digit or another sign for a number, such as a half.
[[nodiscard]] bool is_number(std::int32_t code);
[[nodiscard]] bool is_apostrophe(std::int32_t code);

/// 0 ... 9 for a decimal digit of any script.
[[nodiscard]] std::optional<int> digit_of(std::int32_t code);

/// The name without its ending, such as ".jpg": up to five letters and digits after the last dot,
/// with at least one letter ("10.15" has no ending).
[[nodiscard]] std::string_view without_ending(std::string_view name);

/// A word (letters, with their accents and the apostrophes between them) or a run of digits.
struct NamePart {
    std::string text;  // digits of every script as ASCII
    std::string gap;   // what separates it from the part before; blanks of all kinds as ' '
    bool is_digits = false;
};

/// Takes at most `most_characters` of words and digits. Stray bytes and invisible characters
/// separate words as blanks do.
[[nodiscard]] std::vector<NamePart> parts_of_name(std::string_view name,
                                                  std::size_t most_characters);

struct ClockTime {
    int hour = 0;    // 0 ... 23
    int minute = 0;  // 0 ... 59
    int second = 0;  // 0 ... 59
};

/// A valid day of the years 1900 to 2099, and the time of day if one follows.
struct NameMoment {
    int year = 0;
    int month = 1;
    int day = 1;
    std::optional<ClockTime> clock;
    std::size_t parts = 0;  // how many parts it takes, from the first on
};

/// The moment that the first parts form: "20230405", "2023-04-05 at 10.15.00", "20230405_101500",
/// "05.04.2023". In numbers alone day and month may come in either order, so if both orders are
/// possible it is no date, unless dots separate the numbers.
[[nodiscard]] std::optional<NameMoment> moment_of(std::span<const NamePart> parts);

}  // namespace touchline
