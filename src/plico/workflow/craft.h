// The main job: from a mesh to everything one needs to hold it in hand. Unfold, judge, find a motion and prove it, lay
// out pages, draw them, and make a page that shows it all.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plico/fabricate/fabricate.h"
#include "plico/fold/panel_paint.h"
#include "plico/io/page/drawing.h"
#include "plico/verify/page_layout.h"
#include "plico/workflow/foldable_net.h"
#include "plico/workflow/hand_work.h"
#include "plico/workflow/plan_motion.h"
#include "plico/workflow/segment_mesh.h"
#include "plico/workflow/unfold_mesh.h"

namespace plico {

enum class HandWish { None, Page, Hands };
inline constexpr int kMostToImprove = 1500;  // faces
HandWish hand_wish(std::string_view name);   // "none", "page", "hands"; throws InvalidOption

struct CraftOptions {
  std::string name = "model";  // of the model: titles and file names
  std::string made_by;         // a JSON object for the key plico:report of the FOLD file; may be empty
  // A net that folds with all creases moving by this law is looked for, else one with any motion, as fold_or_plan()
  // does. None: any net, and no motion is looked for.
  std::optional<FoldingLaw> law = FoldingLaw::Linear;
  // Cut into parts that fold instead of one net, as segment_mesh() does; its motion and seed follow from `law` and
  // `unfold`.
  std::optional<SegmentOptions> parts;
  // The parts are given, and where they are glued face to face, as shell_pieces() makes them. Not with `parts`.
  std::optional<Segmentation> pieces;
  std::vector<Joint> joints;
  // Nets that fold straight, and any net when no motion is looked for, are then made better for hands
  // (unfold/handy_folds.h) or for the page; meshes of more faces than kMostToImprove are left as they are.
  HandWish wish = HandWish::Hands;
  UnfoldOptions unfold;
  LayoutOptions layout;
  DrawOptions draw;
  bool one_svg = false;  // of all pages, instead of one a page
  Paint paint;           // how the shape looks: printed, and shown on the page and in pictures
};

struct CraftFile {
  std::string name, bytes;
};

struct CraftResult {
  // Of the search for a net: Found is one net for every component. TimedOut or Stopped also when only the motion was
  // cut short.
  Ending ending = Ending::Exhausted;
  Unfolding net;
  NetVerdict verdict;
  std::vector<char> page_cuts;   // folds of `net`, by edge, at which it was made to be cut for pages; empty for none
  std::optional<Kit> kit;        // of a mesh in several pieces that are to fold: each with its own net and motion
  std::optional<Motion> motion;  // the best that was found, proven or not
  std::string motion_kind;       // "linear", "uniform", "planned"; empty without a motion
  std::string why_no_motion;     // empty with one
  bool drawn = true;  // false: the time was over, and so many panels take long; only NAME.fold and report.json
  PanelPaint paint;   // of the panels of `net`; empty without one, or when not drawn
  LayoutResult layout;
  LayoutVerdict layout_verdict;
  HandWork work;                      // what the pages ask of hands
  std::optional<LargerPages> larger;  // where that is too small for them
  std::vector<Defect> joint_defects;  // of the joints of the kit
  // NAME.pdf, NAME.svg (NAME-1.svg, ... for several pages), NAME.dxf, NAME.fold (with the motion), index.html,
  // report.json; of a kit of several parts also pictures, NAME-assembled.png and NAME-exploded.png
  std::vector<CraftFile> files;

  bool proven() const { return motion && motion->proof.verdict == PathVerdict::Free; }
  bool sound() const { return verdict.valid() && layout_verdict.sound() && joint_defects.empty(); }
};

CraftResult craft(const Mesh& mesh, const CraftOptions& options = {}, const Run& run = {});

// What there is to say about it, as shown on the page and written to report.json. No times: the same answer has the
// same bytes.
nlohmann::json craft_report(const Mesh& mesh, const CraftResult& result);

}  // namespace plico
