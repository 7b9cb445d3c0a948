// touchline-decode-document: decodes drawn files, with the libraries that they need.
#include "app/documents/decode/worker_program.h"

int main(int argc, char** argv) {
    touchline::run_decode_program({touchline::prepare_documents, touchline::decode_document}, argc,
                                  argv);
}
