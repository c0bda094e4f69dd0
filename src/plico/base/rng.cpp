#include "plico/base/rng.h"

#include <bit>
#include <cmath>

#include "plico/base/libm.h"

namespace plico {
namespace {

// SplitMix64 (Steele, Lea and Flood 2014) spreads a seed over the state.
std::uint64_t split_mix(std::uint64_t& x) {
  x += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = x;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace

Rng::Rng(std::uint64_t seed) : seed_(seed) {
  std::uint64_t x = seed;
  for (std::uint64_t& word : state_) word = split_mix(x);
}

Rng Rng::stream(std::uint64_t index) const {
  std::uint64_t x = seed_ ^ (index * 0xd1342543de82ef95ULL + 0x2545f4914f6cdd1dULL);
  return Rng(split_mix(x));
}

std::uint64_t Rng::next() {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Rng::uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

double Rng::uniform(double low, double high) { return low + (high - low) * uniform(); }

double Rng::normal() {
  for (;;) {
    const double x = uniform(-1, 1), y = uniform(-1, 1), r = x * x + y * y;
    if (r > 0 && r < 1) return x * std::sqrt(-2 * plico::log(r) / r);
  }
}

int Rng::below(int n) {
  const std::uint64_t range = static_cast<std::uint64_t>(n);
  const std::uint64_t limit = range * (UINT64_MAX / range);
  for (;;) {
    const std::uint64_t x = next();
    if (x < limit) return static_cast<int>(x % range);
  }
}

}  // namespace plico
