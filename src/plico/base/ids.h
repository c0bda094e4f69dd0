// Ids are types, so a face cannot be handed in where a vertex is meant. An id reads as an int, but no int becomes an id
// without saying so. -1 means none.
#pragma once
#include <compare>

namespace plico {

template <class Tag>
struct Id {
  int value = -1;
  constexpr Id() = default;
  constexpr explicit Id(int i) : value(i) {}
  constexpr operator int() const { return value; }  // NOLINT(google-explicit-constructor): ids index arrays
  constexpr bool valid() const { return value >= 0; }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr std::strong_ordering operator<=>(Id a, Id b) { return a.value <=> b.value; }
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;
using HalfedgeId = Id<struct HalfedgeTag>;

// All ids from 0 to n - 1, for range-based loops.
template <class AnyId>
class IdRange {
 public:
  class iterator {
   public:
    explicit constexpr iterator(int i) : i_(i) {}
    constexpr AnyId operator*() const { return AnyId(i_); }
    constexpr iterator& operator++() {
      ++i_;
      return *this;
    }
    constexpr bool operator!=(const iterator& other) const { return i_ != other.i_; }

   private:
    int i_;
  };
  constexpr IdRange(int first, int last) : first_(first), last_(last) {}
  constexpr explicit IdRange(int n) : IdRange(0, n) {}
  constexpr iterator begin() const { return iterator(first_); }
  constexpr iterator end() const { return iterator(last_); }
  constexpr int size() const { return last_ - first_; }

 private:
  int first_, last_;
};

}  // namespace plico
