// touchline-decode: decodes pictures of pixels.
#include "app/decode/worker_program.h"

int main(int argc, char** argv) {
    using namespace touchline;
    run_decode_program({nullptr, decode_raster}, argc, argv);
}
