// A torus of squares: the simplest 4-regular surface of any size, with a Hamiltonian cycle that is easy to write down.
#pragma once
#include "plico/stack/path_exchange.h"

namespace plico {

inline SquareGraph torus_squares(int columns, int rows) {
  SquareGraph graph;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto square = [&](int i, int j) { return (j + rows) % rows * columns + (i + columns) % columns; };
      graph.neighbours.push_back({square(x + 1, y), square(x, y + 1), square(x - 1, y), square(x, y - 1)});
    }
  return graph;
}

// Row after row, each one square shorter on the way, and back along the first column; `rows` even.
inline std::vector<int> torus_cycle(int columns, int rows) {
  std::vector<int> cycle;
  for (int y = 0; y < rows; ++y)
    for (int i = 1; i < columns; ++i) cycle.push_back(y * columns + (y % 2 == 0 ? i : columns - i));
  for (int y = rows - 1; y >= 0; --y) cycle.push_back(y * columns);
  return cycle;
}

}  // namespace plico
