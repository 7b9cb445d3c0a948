// The words of one language, as an object: two may be used at once, and the process's locale is
// neither asked nor changed. Threads: constant once made; any may read.
#pragma once

#include "config/types/result.h"

#include <initializer_list>
#include <locale>
#include <string>
#include <string_view>
#include <vector>

namespace touchline {

/// Texts are named by their English and where they stand: ("mode", "wall"). English is always
/// there; a text that a catalogue lacks is said in English.
class Language {
  public:
    /// English: needs no file.
    Language();

    /// From FOLDER/CODE.mo, a catalogue of GNU gettext in UTF-8. `code` as of ISO 639 ("de");
    /// "en" needs no file. A file that is missing or no catalogue: one line.
    [[nodiscard]] static Result<Language> load(const std::string& folder, const std::string& code);

    /// {0}, {1}, ... are replaced by `values`; what names none stays. O(length).
    [[nodiscard]] std::string text(const std::string& context, const std::string& english,
                                   std::initializer_list<std::string_view> values = {}) const;

    /// "an outline", "3 outlines": {0} is the count, by the language's own rule of plurals, which
    /// may have any number of forms.
    [[nodiscard]] std::string counted(const std::string& context, const std::string& one,
                                      const std::string& many, int count) const;

    /// "1.5 newtons": as counted, of a value below 1e6, with as many digits as it has, six at most.
    /// The form is that of these digits: a fraction below two has that of none, as French needs it
    /// ("1,5 newton", "0 newton"), a larger one that of its whole part.
    [[nodiscard]] std::string measured(const std::string& context, const std::string& one,
                                       const std::string& many, double value) const;

    /// With `decimals` (0 ... 6) digits after the language's decimal sign.
    [[nodiscard]] std::string number(double value, int decimals) const;

    [[nodiscard]] const std::string& code() const { return code_; }

    /// In itself: "Deutsch".
    [[nodiscard]] std::string name() const { return text("language", "English"); }

    /// Of the speech engine.
    [[nodiscard]] std::string voice() const { return text("voice", "en"); }

    /// How what that voice says wrong is written for it (audio-cues/speech/respelling.h).
    [[nodiscard]] std::string respelling() const;

    /// Words a minute of that voice beside the English one at the same setting: 0.5 ... 2, and 1
    /// where the catalogue does not say.
    [[nodiscard]] double pace() const;

  private:
    [[nodiscard]] std::string form(const std::string& context, const std::string& one,
                                   const std::string& many, int count) const;
    [[nodiscard]] std::string with_sign(std::string digits) const;

    std::string code_ = "en";
    std::locale words_;
};

/// Codes of the catalogues in a folder, sorted, English first: another file is another language. A
/// folder that cannot be read: one line.
[[nodiscard]] Result<std::vector<std::string>> languages_in(const std::string& folder);

}  // namespace touchline
