// Animated GIF: plays everywhere, needs no display and no library to write.
#pragma once
#include <string>
#include <vector>

#include "plico/io/motion/png.h"

namespace plico {

struct GifOptions {
  int delay = 5;         // of a picture, hundredths of a second, at least 2: most programs show faster ones slower
  int last_delay = 100;  // of the last one, before it begins again
};

// Pictures of one size, of which there is at least one, shown for ever; what is transparent becomes white. 256 colours,
// by median cut over all pictures; of a picture only the rectangle that differs from the one before is kept. Source:
// GIF 89a specification; Heckbert, Color image quantization for frame buffer display, SIGGRAPH 1982. O(pixels).
std::string write_gif(const std::vector<Picture>& pictures, const GifOptions& options = {});

}  // namespace plico
