#include "tests/app/main/kiosk_program.h"

#include <cstdlib>

#include <sys/wait.h>

namespace touchline {
namespace {

constexpr const char* script_tools = "program='" TOUCHLINE_PROGRAM
                                     "'\n"
                                     "export TOUCHLINE_GALLERY='" TOUCHLINE_SOURCE_DIR
                                     "/app/documents/gallery/pictures'\n"
                                     "export TOUCHLINE_RECORDINGS=kept\n"
                                     R"(
kiosk() { "$program" "$@" >out.txt 2>err.txt & pid=$!; }
keys() { timeout 100 xdotool search --sync --name '^Touchline$' key --delay 150 "$@" >/dev/null 2>&1; }
wait_for() {
    for _ in $(seq 600); do ! grep -qs "$1" "$2" || return 0; sleep 0.1; done
    echo "'$1' never came in $2" >&2
    kill "$pid"
    exit 98
}
finish() { wait "$pid"; exit $?; }
quit() { keys q Down Return; finish; }
)";

}  // namespace

int KioskProgram::run_script(const std::string& script, bool has_display) {
    const std::filesystem::path path = folder_ / "script.sh";
    std::ofstream(path) << "cd '" << folder_.string() << "'\n" << script_tools << script << '\n';
    // Without a sound card the kiosk says so at a moment of its own, and a key then closes that.
    const std::string settings =
        "SDL_AUDIODRIVER=dummy TOUCHLINE_SETTINGS='" + (folder_ / "kiosk.toml").string() + "' ";
    const std::string display = has_display
                                    ? "LP_NUM_THREADS=1 xvfb-run -a -s '-screen 0 1024x768x24' "
                                    : "env -u DISPLAY -u WAYLAND_DISPLAY ";
    const int status =
        std::system((settings + display + "timeout 240 bash '" + path.string() + "'").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace touchline
