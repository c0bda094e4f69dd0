// Sorting by a number that has few repeats, such as a vertex: linear, where comparisons would take n log n.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace plico {

// Sorts by bucket(item), in [0, buckets), and by `less` within a bucket. O(n) when no bucket is large.
template <class T, class Bucket, class Less>
void sort_in_buckets(std::vector<T>& items, int buckets, Bucket bucket, Less less) {
  std::vector<int> end(static_cast<std::size_t>(buckets) + 1, 0);  // of the bucket before, and then of the bucket
  for (const T& item : items) ++end[bucket(item) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<T> sorted(items.size());
  for (const T& item : items) sorted[end[bucket(item)]++] = item;
  auto first = sorted.begin();
  for (int b = 0; b < buckets; ++b) {
    const auto last = sorted.begin() + end[b];
    if (last - first > 1) std::sort(first, last, less);
    first = last;
  }
  items.swap(sorted);
}

}  // namespace plico
