#include "commands.h"
#include "program.h"

int main(int argc, char** argv) { return plico::cli::run_program(plico::cli::all_commands(), {argv + 1, argv + argc}); }
