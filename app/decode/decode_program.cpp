#include "app/decode/decode_program.h"

#include "app/decode/worker_program.h"

#include <string>
#include <vector>

namespace touchline {

void run_decode_program(const Decoder& decoder, int argc, char** argv) {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto work = work_in(arguments);
    if (!work) refuse_to_run(argv[0]);
    run_worker_program({work->kind, decoder.prepare, [&](std::span<const std::byte> bytes) {
                            return answer_of(decoder.decode(bytes, work->order));
                        }});
}

}  // namespace touchline
