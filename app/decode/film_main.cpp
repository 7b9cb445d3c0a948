// touchline-decode-film: what a film's codec made, HEIC and AVIF.
#include "app/decode/decode_program.h"
#include "app/decode/decoding.h"

int main(int argc, char** argv) {
    using namespace touchline;
    run_decode_program({prepare_films, decode_film}, argc, argv);
}
