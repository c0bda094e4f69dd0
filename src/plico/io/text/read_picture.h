// Pictures from files: PNG and JPEG.
#pragma once
#include <string>
#include <string_view>

#include "plico/base/picture.h"

namespace plico {

// Larger ones are refused before anything is allocated.
constexpr int kMostPictureSide = 16384;        // pixels
constexpr long kMostPicturePixels = 1L << 26;  // 8192 x 8192

// Any PNG or JPEG file, by its contents, in 8 bits a channel. Throws InvalidInput ("picture/...") when it is neither,
// is damaged, or is too large. `name` is for messages. O(pixels).
Picture read_picture(std::string_view bytes, const std::string& name);

}  // namespace plico
