// A speech engine that a text has captured. It is loaded before the real one and does what the text
// names, within touchline-speak as installed. Threads: the program's only one.
#include "tests/app/sound/speak/captured_voice.h"

#include "tests/app/isolation/sandbox/acts.h"

#include <dlfcn.h>
#include <unistd.h>

namespace touchline {
namespace {

int end_of_act(std::string_view name) {
    if (name == "nothing") return act_refused;
    for (const Act& act : acts())
        if (act.name == name) return act.run() >= 0 ? act_worked : act_refused;
    return act_unknown;
}

}  // namespace
}  // namespace touchline

using Synth = int (*)(const void*, std::size_t, unsigned, int, unsigned, unsigned, unsigned*,
                      void*);

/// The engine warms up with its own text before the sandbox is entered; the next text is untrusted.
extern "C" int espeak_Synth(const void* text, std::size_t size, unsigned position, int type,
                            unsigned end, unsigned flags, unsigned* identifier, void* data) {
    static bool is_warm = false;
    if (is_warm) _exit(touchline::end_of_act(static_cast<const char*>(text)));
    is_warm = true;
    const auto real = reinterpret_cast<Synth>(dlsym(RTLD_NEXT, "espeak_Synth"));
    return real(text, size, position, type, end, flags, identifier, data);
}
