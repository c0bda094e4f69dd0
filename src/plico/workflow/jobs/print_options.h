// How pages are laid out and drawn: the options that every command with pages shares, and what they report.
#pragma once
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "plico/fabricate/fabricate.h"
#include "plico/io/page/drawing.h"
#include "plico/mesh/mesh.h"
#include "plico/workflow/jobs/job.h"

namespace plico::jobs {

struct PrintArgs {
  std::string page, margin, up = "auto", tabs = "auto", style = "auto", text = "auto", side = "outside", perforation,
                            unit = "none", machine = "printer", joint = "glue", weak_folds = "auto", title;
  double scale = std::numeric_limits<double>::quiet_NaN();
  double tab_width = 5, tab_angle = radians(45), gap = 3, flat = radians(0.5), label_size = 7;
  SizeOptions size;
  std::vector<std::string> marks;
  bool landscape = false, split = false, no_labels = false, show_flat_creases = false, no_ruler = false,
       one_svg = false, no_legend = false, shadow_tabs = false, no_color = false;
};

void add_print_options(Job& job, PrintArgs& args);
// The axis of --up, guessed and told when it is "auto".
char up_axis(const std::string& wish, const Mesh& mesh, Session& session);
LayoutOptions layout_options(const PrintArgs& args);  // throws InvalidOption
DrawOptions draw_options(const PrintArgs& args, const std::string& default_title);

nlohmann::json json_of(const LayoutReport& report);
std::string layout_text(const LayoutReport& report);  // some lines for people

}  // namespace plico::jobs
