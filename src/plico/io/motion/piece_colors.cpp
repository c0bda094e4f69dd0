#include "plico/io/motion/piece_colors.h"

#include <array>

namespace plico {

// Mid tones on which dark lines show; the first is that of a model in one piece. Neighbours in the list differ in hue
// and in lightness, for readers who see few hues.
constexpr std::array<Color, 10> kPieceColors{{{0.96, 0.69, 0.26},
                                              {0.40, 0.62, 0.80},
                                              {0.62, 0.78, 0.45},
                                              {0.84, 0.43, 0.38},
                                              {0.76, 0.70, 0.88},
                                              {0.33, 0.60, 0.55},
                                              {0.95, 0.86, 0.52},
                                              {0.62, 0.44, 0.66},
                                              {0.93, 0.66, 0.74},
                                              {0.55, 0.50, 0.42}}};

std::vector<Color> piece_colors(const Linkage& linkage) {
  std::vector<std::size_t> piece(linkage.panels.size(), 0);
  std::size_t pieces = 0;
  for (int p : linkage.order) piece[p] = linkage.parent_panel[p] < 0 ? pieces++ : piece[linkage.parent_panel[p]];
  std::vector<Color> colors;
  if (pieces < 2) return colors;
  for (std::size_t which : piece) colors.push_back(kPieceColors[which % kPieceColors.size()]);
  return colors;
}

}  // namespace plico
