// Replaces touchline-import: `list ROOT` answers with bytes that are no listing, `read ROOT FOLDER
// hang MOST` never ends, and with `killed` it ends as the kernel ends who takes its last memory.
#include <csignal>
#include <string_view>

#include <unistd.h>

int main(int argc, char** argv) {
    if (argc > 4 && std::string_view(argv[4]) == "hang")
        for (;;) pause();
    if (argc > 4 && std::string_view(argv[4]) == "killed") return std::raise(SIGKILL);
    constexpr std::string_view lie = "TSL1 and then whatever comes to mind";
    return write(3, lie.data(), lie.size()) == static_cast<ssize_t>(lie.size()) ? 0 : 1;
}
