// A small picture on each page: the finished model, with the parts of that page set off, and their steps below it.
#pragma once
#include <vector>

#include "plico/fold/page_layout.h"
#include "plico/fold/unfolding.h"
#include "plico/font/font.h"

namespace plico {

// Where each panel of a net is in the finished model.
struct ModelView {
  std::vector<std::vector<Vec3>> panels;  // corners, in any unit; empty: the model is not known
  char up = 'y';
};

inline constexpr int kMostToPicture = 3000;  // panels: more are a smear

// Puts the picture into the largest free square of each page, of 40 mm down to 20; a page without one goes without.
// `step` counts from 1, by part. Call it when parts, joints and keys have their place, before edge ids are written,
// which keep clear of it. Returns how many pages have none. O(pages * (places + panels log panels)).
int add_insets(PageLayout& layout, const Unfolding& net, const ModelView& view, const std::vector<int>& step,
               const Font& font);

}  // namespace plico
