#include "plico/font/font.h"

#include <gtest/gtest.h>

#include <string>

namespace plico {
namespace {

TEST(Font, LettersFarAlongALineAreDrawn) {
  const Font font;
  const std::string line(40, 'm');
  const auto outlines = font.outlines(line, 1);
  ASSERT_EQ(outlines.size(), line.size());
  EXPECT_GT(outlines.back().front().x(), font.width(line.substr(1), 1));
}

}  // namespace
}  // namespace plico
