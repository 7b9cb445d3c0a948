// touchline-unpack: the kiosk starts it for one piece of a picture pack. It closes its sandbox, and
// only then reads the first byte.
#include "app/decode/worker_program.h"
#include "app/packs/unpack_program.h"

int main(int argc, char** argv) {
    using namespace touchline;
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!is_unpack_work(words)) refuse_to_run(argv[0]);
    run_worker_program({WorkerKind::pack, {}, [&words](std::span<const std::byte> bytes) {
                            return Result<std::vector<std::byte>>(unpack_work(words, bytes));
                        }});
}
