// Instead of CaDiCaL: no solver. What needs one says so when it comes to it.
#pragma once
#include "plico/base/error.h"

namespace CaDiCaL {

class Terminator {
 public:
  virtual ~Terminator() = default;
  virtual bool terminate() = 0;
};

class Solver {
 public:
  bool set(const char*, int) { return true; }
  void add(int) {}
  void assume(int) {}
  int solve() {
    throw plico::InvalidOption("what is solved by SAT is not in this build", "use the program on a computer");
  }
  int val(int) { return 0; }
  bool failed(int) { return false; }
  void connect_terminator(Terminator*) {}
  void disconnect_terminator() {}
};

}  // namespace CaDiCaL
