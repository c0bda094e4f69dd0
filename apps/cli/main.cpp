#include "commands.h"
#include "plico/motion/planner.h"
#include "program.h"

int main(int argc, char** argv) {
  plico::silence_planners();
  return plico::cli::run_program(plico::cli::all_commands(), {argv + 1, argv + argc});
}
