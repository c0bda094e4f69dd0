// Chapter 6 of the dissertation, and what it left open: every figure beside its goal.
//   bench_stack [--meshes DIR] [--json FILE] [--quick] [--only cycles|stacks|large|motions|proof]
#include <array>
#include <utility>

#include "figure.h"
#include "tables.h"

namespace plico::bench {
namespace {

using Tables = std::vector<Table> (*)(const StackBench&, Goals&);
constexpr std::array<std::pair<const char*, Tables>, 5> kParts{{{"cycles", cycle_tables},
                                                                {"stacks", stack_tables},
                                                                {"large", large_stack_tables},
                                                                {"motions", motion_tables},
                                                                {"proof", proof_tables}}};

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  using namespace plico::bench;
  const std::string only = option_of("--only", argc, argv);
  const Arguments args = arguments(argc, argv);
  Goals goals;
  std::vector<Table> tables;
  for (const auto& [name, make] : kParts)
    if (only.empty() || only == name)
      for (Table& table : make({args.meshes, args.quick}, goals)) tables.push_back(std::move(table));
  tables.push_back(goals.table());
  std::vector<const Table*> all;
  for (const Table& table : tables) all.push_back(&table);
  write_json(args, all);
}
