// The tables of bench_stack, one source each, and what they are held against.
#pragma once
#include <string>
#include <vector>

#include "table.h"

namespace plico::bench {

// What good means, row by row: printed at the end.
class Goals {
 public:
  void add(const std::string& figure, const std::string& goal, const std::string& value, bool reached) {
    rows_.push_back({figure, goal, value, reached ? "yes" : "NO"});
  }
  Table table() const {
    Table table("What good means", {"figure", "goal", "value", "reached"});
    for (const Table::Row& row : rows_) table.row(row);
    return table;
  }

 private:
  std::vector<Table::Row> rows_;
};

struct StackBench {
  std::string meshes;  // a folder of mesh files; empty: only own shapes
  bool quick = false;  // fewer and smaller rows
};

// Cycles: the sizes of the dissertation's table 6.1 beside its seconds, many meshes, growth; voxels.
std::vector<Table> cycle_tables(const StackBench& bench, Goals& goals);

// Stacks: table 6.2 of the dissertation, small shells, many meshes at three thicknesses.
std::vector<Table> stack_tables(const StackBench& bench, Goals& goals);

// Stacks of 10,000 to a million squares.
std::vector<Table> large_stack_tables(const StackBench& bench, Goals& goals);

// From the stack to the shape: how many meshes unpack, by thickness; 60 s each. `quick` looks at every eighth mesh.
std::vector<Table> motion_tables(const StackBench& bench, Goals& goals);

// One long motion, what the proof in the planner costs, and threads.
std::vector<Table> proof_tables(const StackBench& bench, Goals& goals);

}  // namespace plico::bench
