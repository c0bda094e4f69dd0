#include "plico/base/sort_in_buckets.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "plico/base/rng.h"

namespace plico {
namespace {

TEST(SortInBuckets, SortsAsOneSortDoes) {
  Rng rng(7);
  for (int n : {0, 1, 2, 500}) {
    std::vector<std::pair<int, int>> items;
    for (int i = 0; i < n; ++i) items.emplace_back(rng.below(40), rng.below(9));
    std::vector<std::pair<int, int>> wanted = items;
    std::sort(wanted.begin(), wanted.end());
    sort_in_buckets(
        items, 40, [](const auto& item) { return item.first; }, std::less<>());
    EXPECT_EQ(items, wanted);
  }
}

}  // namespace
}  // namespace plico
