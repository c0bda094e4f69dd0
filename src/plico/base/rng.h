// Repeatable randomness: a stream belongs to a seed and an index, never to a thread or a clock; several purposes of one
// seed are numbered, stream(purpose).stream(index). The distributions are ours: the standard ones differ among vendors.
#pragma once
#include <cstdint>

namespace plico {

class Rng {
 public:
  explicit Rng(std::uint64_t seed);

  // An independent stream for item `index`; does not change this one.
  Rng stream(std::uint64_t index) const;

  std::uint64_t next();                     // 64 random bits (xoshiro256++, Blackman and Vigna 2019)
  double uniform();                         // in [0, 1)
  double uniform(double low, double high);  // in [low, high)
  double normal();                          // mean 0, variance 1 (Marsaglia's polar method)
  int below(int n);                         // in [0, n), n >= 1, without modulo bias

 private:
  std::uint64_t state_[4];
  std::uint64_t seed_;
};

}  // namespace plico
