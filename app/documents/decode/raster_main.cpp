// touchline-decode: decodes pictures of pixels.
#include "app/documents/decode/worker_program.h"

int main(int argc, char** argv) {
    touchline::run_decode_program({nullptr, touchline::decode_raster}, argc, argv);
}
