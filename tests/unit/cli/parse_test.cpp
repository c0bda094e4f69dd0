#include "parse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plico/base/error.h"
#include "plico/base/vec.h"

namespace plico::cli {
namespace {

// A command with one row of every kind, and where its values land.
struct Sample {
  std::string mesh, method = "greedy";
  std::vector<std::string> outputs;
  bool force = false;
  int verbose = 0, rounds = 7;
  double ratio = 0.5, height = NAN, tilt = NAN, limit = 0;
  std::uint64_t seed = 1;
  Job command{"sample", "A sample"};

  Sample() {
    command.positional("mesh", "a mesh", mesh)
        .option("-o,--output", "FILE", "where to", outputs)
        .flag("-f,--force", "overwrite", force)
        .count("-v,--verbose", "say more", verbose)
        .option("--rounds", "N", "how many", rounds)
        .option("--ratio", "X", "how much", ratio)
        .option("--seed", "N", "seed", seed)
        .choice("--method", "how", method, {"greedy", "search"})
        .length("--height", "how tall", height)
        .angle("--tilt", "how steep", tilt)
        .duration("--time-limit", "how long", limit);
  }

  std::vector<Given> read(const std::vector<std::string>& words) { return parse(command, command.options, words); }

  // "message / suggestion" of the error, or "no error".
  std::string error(const std::vector<std::string>& words) {
    try {
      read(words);
    } catch (const InvalidOption& e) {
      return std::string(e.what()) + " / " + e.suggestion();
    }
    return "no error";
  }
};

TEST(Parse, SetsEveryKindOfOption) {
  Sample s;
  s.read({"a.obj",        "-o",     "x",        "--output=y", "-oz",    "-fvv",
          "--rounds",     "-3",     "--ratio",  "1e-3",       "--seed", "18446744073709551615",
          "--method",     "search", "--height", "6in",        "--tilt", "30",
          "--time-limit", "2m"});
  EXPECT_EQ(s.mesh, "a.obj");
  EXPECT_EQ(s.outputs, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_TRUE(s.force);
  EXPECT_EQ(s.verbose, 2);
  EXPECT_EQ(s.rounds, -3);
  EXPECT_DOUBLE_EQ(s.ratio, 1e-3);
  EXPECT_EQ(s.seed, 18446744073709551615u);
  EXPECT_EQ(s.method, "search");
  EXPECT_DOUBLE_EQ(s.height, 152.4);
  EXPECT_DOUBLE_EQ(s.tilt, kPi / 6);
  EXPECT_DOUBLE_EQ(s.limit, 120);
}

TEST(Parse, ADashIsAValueAndTwoDashesEndTheOptions) {
  Sample s;
  s.read({"-", "-o", "-"});
  EXPECT_EQ(s.mesh, "-");
  EXPECT_EQ(s.outputs, std::vector<std::string>{"-"});
  Sample t;
  t.read({"--", "--odd-name.obj"});
  EXPECT_EQ(t.mesh, "--odd-name.obj");
}

TEST(Parse, TellsWhatWasGiven) {
  Sample s;
  const std::vector<Given> given = s.read({"--seed", "5", "a.obj"});
  ASSERT_EQ(given.size(), 2u);
  EXPECT_EQ(given[0].option->long_name(), "mesh");
  EXPECT_EQ(given[1].option->long_name(), "--seed");
  EXPECT_EQ(given[1].value, "5");
}

TEST(Parse, MisspeltWordsGetSuggestions) {
  EXPECT_EQ(Sample().error({"a.obj", "--sede", "3"}),
            "unknown option '--sede', did you mean '--seed'? / plico sample --help");
  EXPECT_EQ(Sample().error({"a.obj", "--sede=3"}),
            "unknown option '--sede', did you mean '--seed'? / plico sample --help");
  EXPECT_EQ(Sample().error({"a.obj", "--method", "gredy"}),
            "--method: 'gredy' is not one of greedy, search, did you mean 'greedy'? / ");
  EXPECT_EQ(Sample().error({"a.obj", "--colour"}), "unknown option '--colour' / plico sample --help");
  EXPECT_EQ(Sample().error({"a.obj", "-x"}), "unknown option '-x' / plico sample --help");
}

TEST(Parse, WrongUseIsNamed) {
  EXPECT_EQ(Sample().error({}), "mesh is missing: a mesh / plico sample --help");
  EXPECT_EQ(Sample().error({"a.obj", "b.obj"}), "unexpected argument 'b.obj' / plico sample --help");
  EXPECT_EQ(Sample().error({"a.obj", "--rounds"}), "--rounds needs a value / ");
  EXPECT_EQ(Sample().error({"a.obj", "--rounds", "many"}), "--rounds: 'many' is not a whole number / ");
  EXPECT_EQ(Sample().error({"a.obj", "--rounds", "3.5"}), "--rounds: '3.5' is not a whole number / ");
  EXPECT_EQ(Sample().error({"a.obj", "--rounds", "99999999999"}),
            "--rounds: '99999999999' is out of range for a whole number / ");
  EXPECT_EQ(Sample().error({"a.obj", "--seed", "-1"}), "--seed: '-1' is not a whole number from 0 on / ");
  EXPECT_EQ(Sample().error({"a.obj", "--ratio", "inf"}), "--ratio: 'inf' is not a number / ");
  EXPECT_EQ(Sample().error({"a.obj", "--height", "6inch"}),
            "--height: '6inch' is not a length: its unit 'inch' is unknown / write 150mm, 15cm or 6in");
  EXPECT_EQ(Sample().error({"a.obj", "--seed", "1", "--seed", "2"}), "--seed is given 2 times / give it once");
  EXPECT_EQ(Sample().error({"a.obj", "--force=no"}), "--force: takes no value / ");
}

}  // namespace
}  // namespace plico::cli
