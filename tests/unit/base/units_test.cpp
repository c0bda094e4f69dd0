#include "plico/base/units.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "plico/base/error.h"
#include "plico/base/vec.h"

namespace plico {
namespace {

std::string message_of(double (*parse)(std::string_view), std::string_view text) {
  try {
    parse(text);
  } catch (const InvalidOption& error) {
    return std::string(error.what()) + " / " + error.suggestion();
  }
  return "no error";
}

TEST(Units, LengthsBecomeMillimetres) {
  EXPECT_DOUBLE_EQ(parse_length_mm("150"), 150);
  EXPECT_DOUBLE_EQ(parse_length_mm("150mm"), 150);
  EXPECT_DOUBLE_EQ(parse_length_mm("15 cm"), 150);
  EXPECT_DOUBLE_EQ(parse_length_mm("0.15m"), 150);
  EXPECT_DOUBLE_EQ(parse_length_mm("6in"), 152.4);
  EXPECT_DOUBLE_EQ(parse_length_mm("-1.5e1mm"), -15);
}

TEST(Units, AnglesAreDegreesUnlessSaid) {
  EXPECT_DOUBLE_EQ(parse_angle("180"), kPi);
  EXPECT_DOUBLE_EQ(parse_angle("-90deg"), -kPi / 2);
  EXPECT_DOUBLE_EQ(parse_angle("0.5rad"), 0.5);
}

TEST(Units, DurationsKnowMinutes) {
  EXPECT_DOUBLE_EQ(parse_duration("30"), 30);
  EXPECT_DOUBLE_EQ(parse_duration("2m"), 120);
  EXPECT_DOUBLE_EQ(parse_duration("250ms"), 0.25);
  EXPECT_DOUBLE_EQ(parse_duration("1h"), 3600);
}

TEST(Units, AWrongQuantityIsAnsweredWithExamples) {
  EXPECT_EQ(message_of(parse_length_mm, "6inch"),
            "'6inch' is not a length: its unit 'inch' is unknown / write 150mm, 15cm or 6in");
  EXPECT_EQ(message_of(parse_length_mm, ""), "'' is not a length / write 150mm, 15cm or 6in");
  EXPECT_EQ(message_of(parse_angle, "nan"), "'nan' is not an angle / write 30deg or 0.5rad");
  EXPECT_EQ(message_of(parse_duration, "-1s"), "'-1s' is a negative duration / write 30s, 2m or 1h");
  EXPECT_EQ(message_of(parse_length_mm, "1e999"), "'1e999' is not a length / write 150mm, 15cm or 6in");
}

TEST(Units, MillimetresPerUnit) {
  EXPECT_DOUBLE_EQ(millimetres_per("in"), 25.4);
  EXPECT_THROW(millimetres_per("furlong"), InvalidOption);
}

}  // namespace
}  // namespace plico
