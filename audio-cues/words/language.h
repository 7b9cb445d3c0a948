// The words of one language, as an object: two may be used at once, and the process's locale is
// neither read nor changed. Threads: constant once made; any may read.
#pragma once

#include "audio-cues/cues/guidance.h"
#include "config/types/result.h"
#include "config/types/thing_name.h"

#include <initializer_list>
#include <locale>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// Texts are named by their English and by their context: ("mode", "wall"). English always exists;
/// a text that a catalogue lacks is given in English.
class Language {
  public:
    /// English, which needs no file.
    Language();

    /// Loads FOLDER/CODE.mo, a catalogue of GNU gettext in UTF-8. `code` is from ISO 639 ("de");
    /// "en" needs no file. A missing file, or one that is not a catalogue, gives a one-line error.
    [[nodiscard]] static Result<Language> load(const std::string& folder, const std::string& code);

    /// Replaces {0}, {1}, ... by `values`; placeholders without a value stay. O(length).
    [[nodiscard]] std::string text(const std::string& context, const std::string& english,
                                   std::initializer_list<std::string_view> values = {}) const;

    /// "an outline", "3 outlines": {0} is the count. The form follows the language's own plural
    /// rule, which may have any number of forms.
    [[nodiscard]] std::string counted(const std::string& context, const std::string& one,
                                      const std::string& many, int count) const;

    /// "1.5 newtons": like counted(), for a value below 1e6, with as many digits as it has, at most
    /// six. The form follows these digits: a fraction below two has the form of zero, as French
    /// needs it ("1,5 newton", "0 newton"), a larger one that of its whole part.
    [[nodiscard]] std::string measured(const std::string& context, const std::string& one,
                                       const std::string& many, double value) const;

    /// Returns the number with `decimals` (0 ... 6) digits after the language's decimal sign.
    [[nodiscard]] std::string number(double value, int decimals) const;

    [[nodiscard]] const std::string& code() const { return code_; }

    /// The language's name in itself: "Deutsch".
    [[nodiscard]] std::string name() const { return text("language", "English"); }

    /// The speech engine's voice.
    [[nodiscard]] std::string voice() const { return text("voice", "en"); }

    /// How to write for that voice what it would say wrong (audio-cues/speech/speech_input.h).
    [[nodiscard]] std::string respelling() const;

    /// The voice's words a minute, relative to the English one at the same setting: 0.5 ... 2, and
    /// 1 if the catalogue does not say.
    [[nodiscard]] double pace() const;

  private:
    [[nodiscard]] std::string form(const std::string& context, const std::string& one,
                                   const std::string& many, int count) const;
    [[nodiscard]] std::string with_sign(std::string digits) const;

    std::string code_ = "en";
    std::locale words_;
};

/// Returns the codes of the catalogues in a folder, sorted, English first: a new file is a new
/// language. A folder that cannot be read gives a one-line error.
[[nodiscard]] Result<std::vector<std::string>> languages_in(const std::string& folder);

// Places, sounds, and what a network sees in a picture, in words.

/// Returns words such as "upper left".
[[nodiscard]] std::string words_of(Place place, const Language& language);

/// Returns the name of a sound, as in the list of sounds.
[[nodiscard]] std::string words_of(Cue cue, const Language& language);

/// Returns "a dog", "3 dogs"; from 4 on "4 dogs or more", because a network's count is unreliable.
/// `count` >= 1.
[[nodiscard]] std::string words_of(ThingName name, int count, const Language& language);

/// Returns "on the left", "at the top, right of the middle", "in most of the picture".
[[nodiscard]] std::string words_of(const ThingBox& box, const Language& language);

/// Returns "Probably a dog, left of the middle. And probably 2 people, on the right.": a sentence
/// for each name, in the order in which the names first appear; each guess is told as a guess.
/// Returns "" for no things. Boxes must be sound.
[[nodiscard]] std::string words_of(std::span<const NamedThing> things, const Language& language);

}  // namespace touchline
