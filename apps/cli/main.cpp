#include "program.h"

int main(int argc, char** argv) { return plico::cli::run_program({argv + 1, argv + argc}); }
