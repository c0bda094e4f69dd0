// All crease patterns of a folder, read, folded and judged: one row each, as a page to look at and as a table to count.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/fold/crease_pattern.h"
#include "plico/io/pattern/imported_pattern.h"
#include "plico/workflow/plan_motion.h"

namespace plico {

struct GalleryOptions {
  MotionOptions motion;
  DrawingOptions drawing;
  double seconds_each = 0;  // for one pattern; 0: no limit. Answers that a limit cuts short differ between machines
};

struct GalleryRow {
  std::string file;
  std::string refused;  // why it could not be read or planned; empty when it could
  int vertices = 0, creases = 0, panels = 0, sheets = 0;
  std::vector<std::string> read_notes, motion_notes;
  bool planned = false, proven = false;
  Ending ending = Ending::Exhausted;
  double settled = 0, settled_share = 0;  // largest move of a vertex, in units and shortest edges; 0 as drawn
  bool cut = false;                       // panels, by flat creases
  int bent = 0;                           // panels that bend along them
  double bend = 0;                        // of the one that bends most, radians
  double progress = 0;                    // of the way to the goal, of the motion; 0 without one
  double seconds = 0;                     // of planning and proof
  std::vector<std::string> why_not;       // the notes that say what stops it
  std::string pattern_svg, folded_svg;    // thumbnails; empty when there is nothing to see
};

// Reads and plans one pattern as plico fold does. Input that cannot be used is told in the row; nothing is thrown but
// for options that are wrong.
GalleryRow gallery_row(const std::string& file, std::string_view bytes, const GalleryOptions& options = {},
                       const Run& run = {});

// One HTML page without anything outside it, and the same figures as comma-separated values with a header line.
std::string gallery_page(const std::vector<GalleryRow>& rows);
std::string gallery_csv(const std::vector<GalleryRow>& rows);

// Counts of rows: "41 patterns: 41 read, 9 reach their goal, ...".
std::string gallery_summary(const std::vector<GalleryRow>& rows);

}  // namespace plico
