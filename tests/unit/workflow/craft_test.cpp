#include "plico/workflow/craft.h"

#include <gtest/gtest.h>

#include "plico/shapes/named_shapes.h"

namespace plico {
namespace {

// Asks the work to stop as soon as it comes to a phase.
class StopAt final : public Progress {
 public:
  explicit StopAt(std::string phase) : phase_(std::move(phase)) {}
  void report(std::string_view phase, long, long, std::string_view) override {
    if (phase == phase_) stop_.request_stop();
  }
  std::stop_token token() const { return stop_.get_token(); }

 private:
  std::string phase_;
  std::stop_source stop_;
};

CraftResult stopped(int faces, const char* phase, std::optional<FoldingLaw> law = {}) {
  StopAt listener(phase);
  CraftOptions options;
  options.law = law;
  return craft(Mesh(make_shape("grid", {.faces = faces})), options, {.stop = listener.token(), .progress = &listener});
}

std::vector<std::string> names(const CraftResult& result) {
  std::vector<std::string> all;
  for (const CraftFile& file : result.files) all.push_back(file.name);
  return all;
}

TEST(Craft, StoppedWhileManyPanelsAreDrawnItHasTheNetAlone) {
  for (const char* phase : {"making tabs", "writing labels", "drawing pages"}) {
    const CraftResult result = stopped(10'404, phase);
    EXPECT_EQ(result.ending, Ending::Stopped) << phase;
    EXPECT_FALSE(result.drawn);
    EXPECT_TRUE(result.sound());
    EXPECT_TRUE(result.verdict.valid());
    EXPECT_EQ(names(result), (std::vector<std::string>{"model.fold", "report.json"}));
  }
}

TEST(Craft, StoppedWhileOneThatFoldsIsSoughtItHasTheNetAtHand) {
  const CraftResult result = stopped(10'404, "looking for a net that folds", FoldingLaw::Linear);
  EXPECT_EQ(result.ending, Ending::Stopped);
  EXPECT_TRUE(result.verdict.valid());
  EXPECT_EQ(result.verdict.parts, 1);
  EXPECT_FALSE(result.motion.has_value());
  EXPECT_EQ(result.why_no_motion, "the time was over");
  EXPECT_EQ(names(result), (std::vector<std::string>{"model.fold", "report.json"}));
}

TEST(Craft, AFewPanelsAreDrawnToTheEnd) {
  const CraftResult result = stopped(100, "making tabs");
  EXPECT_EQ(result.ending, Ending::Found);
  EXPECT_TRUE(result.drawn);
  EXPECT_EQ(names(result), (std::vector<std::string>{"model.pdf", "model.svg", "model.dxf", "model.fold", "report.json",
                                                     "index.html"}));
}

}  // namespace
}  // namespace plico
