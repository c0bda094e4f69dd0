// One HTML file that shows a folding sheet: in space and flat side by side, with a slider, offline from disk, without a
// graphics card. The page composes the rotations itself, from fold angles and the tree; it computes nothing else.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plico/base/picture.h"
#include "plico/fold/folding_path.h"
#include "plico/fold/page_layout.h"
#include "plico/io/motion/stand.h"

namespace plico {

enum class ProofStatus { Unchecked, Proven, Collides, Undecided };

// Two panels that share interior points from time `begin` to time `end`.
struct ViewerCollision {
  double begin = 0, end = 0;
  int panel_a = -1, panel_b = -1;
};

struct ViewerInput {
  std::string title = "Plico";
  std::string unit;  // of lengths; empty for none
  Linkage linkage;   // its flat panels are the drawing of the net

  Stand stand;  // turns the whole while it folds

  std::optional<FoldingPath> path;  // none: straight from flat to folded
  double start = 0;                 // the moment shown first, in [0, 1]
  std::string motion;               // "linear", "uniform", "planned"; empty when nobody said
  ProofStatus proof = ProofStatus::Unchecked;
  std::string proof_note;  // one sentence about how it was proven
  std::vector<ViewerCollision> collisions;

  // As on the printed pages: of each side of each panel what it is glued to ("12", "B3"; "" for none), and the letter
  // of each panel's part. Empty when there are no pages.
  std::vector<std::vector<std::string>> side_ids;
  std::vector<std::string> part_of_panel;
  std::optional<PageLayout> pages;  // the pages themselves, shown flat in place of the linkage, every panel once
  std::vector<Color> colors;        // of the fronts of panels; empty: one a piece

  std::string report;                                         // one JSON object, shown as a table; empty for none
  std::vector<std::pair<std::string, std::string>> links;     // label and address of files beside the page
  std::vector<std::pair<std::string, std::string>> pictures;  // caption and bytes of PNG files, shown below the views
  // How pieces are put together once they are folded: a motion of every panel, the same for all of a part; empty: none.
  // Then folding takes the first part of the slider, and putting together the rest.
  std::vector<Pose> home;
};

// The page, complete; the same input gives the same bytes. Throws InvalidInput when `report` is not a JSON object, or a
// collision or the path does not fit the linkage, or the motion goes beyond the limits of a hinge. O(panels + waypoints
// * hinges).
std::string viewer_page(const ViewerInput& input);

}  // namespace plico
