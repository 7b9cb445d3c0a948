// touchline-decode-document: decodes drawn files, with the libraries that they need.
#include "app/decode/worker_program.h"

int main(int argc, char** argv) {
    using namespace touchline;
    run_decode_program({prepare_documents, decode_document}, argc, argv);
}
