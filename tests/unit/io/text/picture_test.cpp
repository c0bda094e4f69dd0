#include <gmock/gmock.h>

#include "plico/base/error.h"
#include "plico/io/text/base64.h"
#include "plico/io/text/png.h"
#include "plico/io/text/read_picture.h"

namespace plico {
namespace {

using ::testing::HasSubstr;

const Picture kTwo{2, 1, {255, 0, 0, 255, 0, 0, 255, 128}};

std::string code_of(const std::string& bytes) {
  try {
    read_picture(bytes, "skin.png");
  } catch (const InvalidInput& error) {
    return error.code();
  }
  return "none";
}

TEST(ReadPicture, GivesBackThePixelsOfAPng) {
  const Picture read = read_picture(write_png(kTwo), "skin.png");
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.height, 1);
  EXPECT_EQ(read.rgba, kTwo.rgba);
}

TEST(ReadPicture, RefusesWhatIsNoPictureAndWhatIsCutShort) {
  EXPECT_EQ(code_of("GIF89a"), "picture/format");
  EXPECT_EQ(code_of(write_png(kTwo).substr(0, 40)), "picture/damaged");
  EXPECT_EQ(code_of("\xff\xd8\xff\xe0 no more"), "picture/damaged");
}

TEST(ReadPicture, RefusesAbsurdSizesBeforeTheyAreAllocated) {
  std::string png = write_png(kTwo);
  png.replace(16, 8, std::string("\x00\x00\xff\xff\x00\x00\xff\xff", 8));  // width and height
  EXPECT_THAT(code_of(png), HasSubstr("picture/"));
}

TEST(Base64, ReadsWhatItWrites) {
  for (const std::string bytes : {"", "a", "ab", "abc", "abcd"}) EXPECT_EQ(decoded_base64(base64(bytes)), bytes);
  EXPECT_FALSE(decoded_base64("a-b"));
}

}  // namespace
}  // namespace plico
