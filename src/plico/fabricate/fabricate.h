// From a net to something to hold: one layout in millimetres with tabs, labels and marks, ready to be drawn.
#pragma once
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fabricate/assembly.h"
#include "plico/fabricate/hand_measures.h"
#include "plico/fabricate/inset.h"
#include "plico/fabricate/joints.h"
#include "plico/fabricate/labels.h"
#include "plico/fabricate/marks.h"
#include "plico/fabricate/page.h"
#include "plico/fabricate/place.h"
#include "plico/fabricate/tabs.h"
#include "plico/fold/page_layout.h"

namespace plico {

// What a part of the net is called on paper: a short id, as "A", and a name to read, as "head", which may be empty.
struct PartTitle {
  std::string id, name;
};

// Folds that are too short for what hangs on them (hand_measures.h): kept, or cut so that they are glued; CutFew where
// parts may be split and at most one panel in kPanelsACut gains a cut.
enum class WeakFolds { Keep, CutFew, Cut };
inline constexpr int kPanelsACut = 20;

// Where someone wants a part to lie, told by one of its panels: the panel's first corner on the page, millimetres from
// its lower left corner, and the direction of its first side, radians, 0 to the right. It needs no other part and no
// order of parts, so it holds for as long as the panel is there.
struct PanelPlace {
  int panel = -1, page = 0;  // of the net; from 0
  Vec2 at = Vec2::Zero();
  double angle = 0;
};

struct LayoutOptions {
  SizeOptions size;
  PageOptions page;
  PlaceOptions place;
  std::vector<PanelPlace> places;  // of parts that lie where they are told; of a part told twice the last counts
  TabOptions tabs;
  LabelOptions labels;
  MarkOptions marks;
  bool split = false;  // cut parts that are too large for a page
  // Folds to cut them at, by edge of the net, from page_cuts(); where these do not do others are cut, too. May be
  // empty.
  std::vector<char> cuts;
  WeakFolds weak_folds = WeakFolds::Keep;
  double flat = radians(0.5);      // folds up to this angle count as flat, radians
  std::vector<PartTitle> titles;   // of each part of the net; empty: "A", "B", ...
  std::vector<int> seams;          // number of each sheet edge glued to another part; empty, or 0 of all: numbered here
  std::vector<int> rank;           // of each part of the net in the order of assembly; empty: by the seams
  std::vector<JointFacet> joints;  // facets that meet facets of other parts
  JointKind joint = JointKind::Glue;
  bool may_give_up = false;  // when the run is over: no layout instead of a late one
};

struct LayoutReport {
  double scale = 1;                // millimetres per unit
  Vec3 final_size = Vec3::Zero();  // of the folded model, millimetres
  int pages = 0, parts = 0;
  int folds_cut = 0;  // by splitting
  int weak_folds_cut = 0;
  HandMeasures hands;     // of the printed parts
  double fill_ratio = 0;  // parts and tabs over printable area
  Tabs tabs;              // tabs made, shrunk, moved, omitted
  LabelReport labels;
  int joints_unnamed = 0;       // facets of joints that are too small for their text
  int joints_without_hole = 0;  // of rivets, too small for the hole
  int pages_without_ruler = 0;
  int pages_without_picture = 0;    // of the model, when there are several parts and their places are known
  std::vector<AssemblyStep> steps;  // of the printed parts, when there are several
  // As printed: of each edge of the net, "" for none; and the letter of the part that each panel is printed in. Edges
  // that splitting made follow after those of the net.
  std::vector<std::string> edge_ids, part_of_panel;
  std::vector<std::string> part_names;  // of each printed part
  std::vector<int> page_of_part;        // from 0
  std::vector<PanelPlace> places;       // where each printed part lies, by its lowest panel
  std::vector<int> printed_part;        // of each panel, a number in `places`
};

struct LayoutResult {
  bool given_up = false;  // the rest is not whole then
  PageLayout layout;
  LayoutReport report;
};

// What a net may take of a page, so that there is room for its tabs.
Vec2 room_without_tabs(const LayoutOptions& options);

// The scale at which lay_out_pages() prints: millimetres per unit.
double wanted_scale(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options = {});

// Folds of `net` at which parts too large for a page at `scale` are cut, by edge; empty when all fit.
std::vector<char> page_cuts(const Unfolding& net, double scale, const LayoutOptions& options = {});

// Lays out `net` (in the model's unit). Throws InvalidInput when a part fits no page, saying the largest size that
// would fit, unless it may be split; InvalidOption when an option is out of range. Parts with a given place may overlap
// and reach over the margin: verify_layout() tells.
LayoutResult lay_out_pages(const Unfolding& net, const FoldedShape& shape, const LayoutOptions& options = {},
                           const Run& run = {});

}  // namespace plico
