// touchline-decode-heif: decodes HEIC and AVIF.
#include "app/decode/worker_program.h"

int main(int argc, char** argv) {
    using namespace touchline;
    run_decode_program({prepare_heif, decode_heif}, argc, argv);
}
