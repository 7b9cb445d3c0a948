// touchline-decode, touchline-decode-heif and touchline-decode-document: TOUCHLINE_DECODER is each
// one's own, because each has the libraries of its formats alone.
#include "app/documents/decode/worker_program.h"

int main(int argc, char** argv) {
    touchline::run_decode_program(touchline::TOUCHLINE_DECODER, argc, argv);
}
