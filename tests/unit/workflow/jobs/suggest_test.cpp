#include "plico/workflow/jobs/suggest.h"

#include <gtest/gtest.h>

namespace plico::jobs {
namespace {

TEST(Suggest, FindsTheNearestWord) {
  const std::vector<std::string> words = {"--seed", "--threads", "--time-limit"};
  EXPECT_EQ(nearest_word("--sede", words), "--seed");
  EXPECT_EQ(nearest_word("--treads", words), "--threads");
  EXPECT_EQ(nearest_word("--timelimit", words), "--time-limit");
}

TEST(Suggest, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(nearest_word("--colour", {"--seed", "--threads"}), "");
  EXPECT_EQ(nearest_word("x", {}), "");
}

TEST(Suggest, SwappedNeighboursAreOneMistake) { EXPECT_EQ(nearest_word("mna", {"man", "map"}), "man"); }

}  // namespace
}  // namespace plico::jobs
