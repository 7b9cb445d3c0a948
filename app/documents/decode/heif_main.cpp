// touchline-decode-heif: decodes HEIC and AVIF.
#include "app/documents/decode/worker_program.h"

int main(int argc, char** argv) {
    touchline::run_decode_program({touchline::prepare_heif, touchline::decode_heif}, argc, argv);
}
