// plico export: a net or a motion as animation, robot model, table, page or picture.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/base/units.h"
#include "plico/fold/plain_hinges.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/io/motion/angle_plot.h"
#include "plico/io/motion/csv.h"
#include "plico/io/motion/gif.h"
#include "plico/io/motion/gltf.h"
#include "plico/io/motion/mjcf.h"
#include "plico/io/motion/panel_solid.h"
#include "plico/io/motion/png.h"
#include "plico/io/motion/urdf.h"
#include "plico/io/motion/viewer.h"
#include "plico/io/pattern/cp.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/pattern/fold_colors.h"
#include "plico/io/pattern/ori.h"
#include "plico/io/pattern/svg_pattern.h"
#include "plico/io/text/file.h"
#include "plico/verify/path.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/motion_report.h"
#include "plico/workflow/jobs/print_options.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/kit.h"
#include "plico/workflow/show_proof.h"
#include "plico/workflow/stack_views.h"
#include "plico/workflow/stand.h"

namespace plico::jobs {
namespace {

constexpr double kProofSeconds = 20;  // for the page's verdict
constexpr int kMostPictures = 1000;   // of a film: they are in memory together

struct ExportArgs {
  std::string file, trajectory, title, up = "auto", unit = "none";
  double at = 1, seconds = 4, grams_per_square_metre = 160, sheet_thickness_mm = 0.2;
  double azimuth = radians(-35), elevation = radians(28);
  double longest_mm = std::numeric_limits<double>::quiet_NaN();  // of the folded model, in robot models
  int width = 0, height = 0;                                     // pixels; 0: as many as are usual for the format
  bool transparent = false;
};

// What every format is written from.
struct LoadedMotion {
  FoldFile file;
  Linkage linkage;
  FoldingPath path;
  std::string title;
  std::optional<ChainClaim> chain = {};  // of thick squares
  Stand stand = {};                      // of a net that knows its mesh
  std::vector<Pose> home = {};           // of a folded kit that knows its mesh: each panel to its place in the model

  // How panels are shown at a moment: turned to stand, and, once folded, put together.
  std::vector<Pose> poses(double time) const {
    std::vector<Pose> result = folding_map(linkage, path.at(time));
    for (std::size_t p = 0; p < result.size(); ++p)
      result[p] = Pose(stand.at(time)) * (time == 1 && !home.empty() ? home[p] * result[p] : result[p]);
    return result;
  }
};

// A chain of thick squares never lies flat; without a motion all there is to show is its shape.
FoldingPath resting_in_shape(const Linkage& chain) { return {{{0, goal(chain)}, {1, goal(chain)}}}; }

std::string name_of(const std::string& path) {
  return path == "-" ? "sheet" : std::filesystem::path(path).stem().string();
}

LoadedMotion read_motion(const ExportArgs& args, Session& session) {
  LoadedMotion motion{read_sheet(args.file, session), {}, {}, args.title};
  motion.chain = chain_claim(motion.file);
  if (motion.chain) take_told_motion(motion.file, *motion.chain);
  motion.linkage =
      motion.chain ? chain_linkage_of(*motion.chain) : make_linkage(motion.file.net.sheet, motion.file.net.mate);
  if (!args.trajectory.empty()) {
    if (args.file == "-") throw InvalidOption("--trajectory needs the sheet in a file of its own, not standard input");
    const std::string sheet = session.read(args.file), trajectory = session.read(args.trajectory);
    set_path(motion.file, motion.linkage, read_trj(trajectory, read_ori(sheet, args.file), args.trajectory));
  }
  motion.path = motion.file.path ? *motion.file.path
                : motion.chain   ? resting_in_shape(motion.linkage)
                                 : linear_path(motion.linkage);
  if (motion.title.empty()) motion.title = name_of(args.file);
  const FoldFile& file = motion.file;
  if (args.up == "sheet" || file.folded.empty() || file.net.mesh_face.empty() || file.net.mesh_vertex.empty())
    return motion;
  const Mesh mesh = folded_mesh(file);
  const char up = up_axis(args.up, mesh, session);
  motion.stand = stand_of(file.net, motion.linkage, mesh, up);
  if (file.net.num_parts() > 1 && motion.path.at(1).isApprox(goal(motion.linkage)))
    motion.home = standing(assembled(mesh, file.net), up);
  return motion;
}

// How large one unit is: as asked for, as the file says, or a millimetre, which is told.
double metres_per_unit(const LoadedMotion& motion, const ExportArgs& args, Session& session) {
  constexpr std::string_view kLengths[] = {"mm", "cm", "m", "in", "ft"};
  const bool says = std::ranges::find(kLengths, motion.file.unit) != std::end(kLengths);
  if (args.unit != "none") {
    if (!std::isnan(args.longest_mm)) throw InvalidOption("--unit and --longest both say how large the robot is");
    return millimetres_per(args.unit) / 1000;
  }
  const double per_unit = says ? millimetres_per(motion.file.unit) / 1000 : 0.001;
  Eigen::AlignedBox3d box;
  const std::vector<Pose> poses = folding_map(motion.linkage, motion.path.at(1));
  for (int p = 0; p < motion.linkage.num_panels(); ++p)
    for (const Vec3& v : motion.linkage.panels[p]) box.extend(motion.stand.at(1) * (poses[p] * v));
  const double longest = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  if (std::isnan(args.longest_mm)) {
    if (!says)
      session.warn(fmt::format(
          "the robot is {:.3g} mm long, one unit being a millimetre; --longest says how large it is", longest));
    return per_unit;
  }
  require(args.longest_mm > 0 && longest > 0, "longest", args.longest_mm, "above 0 mm");
  return args.longest_mm / longest / 1000;
}

RobotOptions robot_options(const LoadedMotion& motion, const ExportArgs& args, Session& session) {
  RobotOptions options;
  options.metres_per_unit = metres_per_unit(motion, args, session);
  options.name.clear();
  for (unsigned char c : motion.title) options.name += std::isalnum(c) || c == '-' ? static_cast<char>(c) : '_';
  options.grams_per_square_metre = args.grams_per_square_metre;
  options.sheet_thickness_mm = args.sheet_thickness_mm;
  options.seconds = args.seconds;
  return options;
}

std::string robot_file(const RobotFile& file, Session& session) {
  for (const std::string& warning : file.warnings) {
    session.warn(warning);
    session.report()["warnings"].push_back(warning);
  }
  return file.text;
}

PictureOptions picture_options(const ExportArgs& args, int usual_width) {
  PictureOptions options;
  options.width = args.width > 0 ? args.width : usual_width;
  options.height = args.height > 0 ? args.height : 3 * options.width / 4;
  options.transparent = args.transparent;
  options.camera.azimuth = args.azimuth;
  options.camera.elevation = args.elevation;
  return options;
}

std::string picture(const LoadedMotion& motion, const ExportArgs& args) {
  PictureOptions options = picture_options(args, 1200);
  options.turn = motion.stand.at(args.at);
  options.colors = colors_of(motion.file);
  if (args.at == 1) options.home = motion.home;
  return render_png(motion.linkage, motion.path.at(args.at), options);
}

// The panels at a moment of the motion, as they are shown: a net with the vertices of its sheet, a thick chain as
// solids.
PolygonSoup surface_at(const LoadedMotion& motion, double time) {
  const std::vector<Pose> poses = motion.poses(time);
  PolygonSoup soup;
  if (!motion.chain) soup.points.resize(motion.file.net.sheet.vertices.size(), Vec3::Zero());
  for (int p = 0; p < motion.linkage.num_panels(); ++p) {
    const auto shown = [&](const Vec3& v) -> Vec3 { return poses[p] * v; };
    if (!motion.chain) {
      const std::vector<int>& face = motion.file.net.sheet.faces[p];
      for (std::size_t i = 0; i < face.size(); ++i) soup.points[face[i]] = shown(motion.linkage.panels[p][i]);
      soup.add_face(face);
      continue;
    }
    const PanelSolid solid = panel_solid(motion.linkage, p);
    const int first = soup.num_points();
    for (const Vec3& v : solid.points) soup.points.push_back(shown(v));
    for (const auto* side : {&solid.front, &solid.back, &solid.walls})
      for (const auto& [a, b, c] : *side) soup.add_face({first + a, first + b, first + c});
  }
  return soup;
}

// All pictures share one camera, which has room for every moment.
std::string film(const LoadedMotion& motion, const ExportArgs& args, const Run& run) {
  constexpr int kMoments = 12;
  const GifOptions pace;
  PictureOptions options = picture_options(args, 600);
  options.transparent = false;
  options.colors = colors_of(motion.file);
  for (int i = 0; i <= kMoments; ++i) {
    const std::vector<Vec3> points = surface_at(motion, double(i) / kMoments).points;
    options.room.insert(options.room.end(), points.begin(), points.end());
  }
  const double wanted = std::ceil(100 * args.seconds / pace.delay);
  if (wanted > kMostPictures)
    throw InvalidOption(
        fmt::format("{:g} s are {:g} pictures, at most {} go into a GIF", args.seconds, wanted, kMostPictures));
  const int count = std::max(2, static_cast<int>(wanted));
  std::vector<Picture> pictures;
  for (int i = 0; i < count; ++i) {
    const double time = double(i) / (count - 1);
    options.turn = motion.stand.at(time);
    if (time == 1) options.home = motion.home;
    run.report("drawing pictures", i, count);
    pictures.push_back(render(motion.linkage, motion.path.at(time), options));
  }
  return write_gif(pictures, pace);
}

// As `plico fold` and `plico unfold` note it; empty when nobody did.
std::string planner_of(const FoldFile& file) {
  const nlohmann::json report = nlohmann::json::parse(file.report, nullptr, false);
  if (!report.is_object() || !report.contains("motion") || !report["motion"].is_object()) return "";
  const std::string planner = report["motion"].value("planner", "");
  return planner.empty() || planner == "linear" || planner == "uniform" ? planner : "planned";
}

void add_chain_proof(ViewerInput& page, const ChainClaim& claim, Session& session) {
  const ChainMotionVerdict verdict = judge_chain_motion(claim, *page.path, {}, limited(session.run(), kProofSeconds));
  show_proof(page, verdict);
  session.report()["motion"] = {{"verdict", name(verdict.verdict)}, {"opened", verdict.opened}};
  session.say(fmt::format("motion: {}", page.proof_note));
}

// Who shows a motion wants to know whether it folds; what the file says about that is a claim, so it is proven again.
void add_proof(ViewerInput& page, Session& session) {
  const PathProof proof = prove_path(page.linkage, *page.path, {}, limited(session.run(), kProofSeconds));
  show_proof(page, proof);
  page.proof_note = motion_line(proof);
  session.report()["motion"] = motion_json(proof);
  session.say(fmt::format("motion: {}", motion_line(proof)));
}

std::string page(const LoadedMotion& motion, Session& session) {
  ViewerInput input;
  input.title = motion.title;
  input.unit = motion.file.unit == "unit" ? "" : motion.file.unit;
  input.linkage = motion.linkage;
  input.path = motion.path;
  input.stand = motion.stand;
  input.home = motion.home;
  input.colors = colors_of(motion.file);
  input.motion = motion.file.path ? planner_of(motion.file) : "linear";
  input.report = motion.file.report;
  if (motion.chain) {
    input.motion = motion.file.path ? "unpacking" : "";
    if (motion.file.path) add_chain_proof(input, *motion.chain, session);
  } else if (motion.linkage.num_hinges() > 0) {
    add_proof(input, session);
  }
  return viewer_page(input);
}

// Joints of files that know of one axis each.
LoadedMotion with_plain_hinges(LoadedMotion motion) {
  motion.linkage = plain_hinged(motion.linkage);
  motion.path = plain_path(motion.path);
  return motion;
}

std::string with_joints(std::string_view kind, const LoadedMotion& motion, const ExportArgs& args, Session& session) {
  if (kind == "glb") return write_glb(motion.linkage, motion.path, {.seconds = args.seconds});
  const RobotOptions options = robot_options(motion, args, session);
  return robot_file(kind == "urdf" ? write_urdf(motion.linkage, motion.path, options)
                                   : write_mjcf(motion.linkage, motion.path, options),
                    session);
}

std::string bytes_for(const std::string& path, const LoadedMotion& motion, const ExportArgs& args, Session& session) {
  const std::string kind = extension(path);
  if (kind == "csv" || path.ends_with(".angles.svg")) require_within_limits(motion.linkage, motion.path);
  if (path.ends_with(".angles.svg")) return write_angle_plot(motion.path, {.title = motion.title});
  if (kind == "glb" || kind == "urdf" || kind == "xml" || kind == "mjcf")
    return with_joints(kind, has_thick_hinges(motion.linkage) ? with_plain_hinges(motion) : motion, args, session);
  if (kind == "csv") return write_trajectory_csv(motion.path, motion.linkage.hinges);
  if (kind == "png") return picture(motion, args);
  if (kind == "gif") return film(motion, args, session.run());
  if (const auto mesh = mesh_format_of(path); mesh && *mesh != MeshFormat::Gltf)
    return write_mesh(surface_at(motion, args.at), *mesh);
  if (kind == "html" || kind == "htm") return page(motion, session);
  if (kind == "svg") return write_svg_pattern(motion.file.net.sheet);
  if (kind == "cp") return write_cp(motion.file.net.sheet);
  if (kind == "fold") return write_fold(motion.file);
  throw InvalidOption(
      fmt::format("cannot tell what to write from '{}'; the extensions are glb, urdf, xml, csv, png, html, gif, obj, "
                  "stl, off, ply, fold, svg, cp, angles.svg",
                  path));
}

int export_file(const ExportArgs& args, Session& session) {
  require(args.at >= 0 && args.at <= 1, "at", args.at, "in [0, 1]");
  const std::string default_path = args.file == "-" ? "sheet.html" : name_of(args.file) + ".html";
  const std::vector<std::string> outputs = session.outputs(default_path);
  const LoadedMotion motion = read_motion(args, session);
  nlohmann::json& report = session.report();
  report["panels"] = motion.linkage.num_panels();
  report["hinges"] = motion.linkage.num_hinges();
  report["loop_hinges"] = motion.linkage.loop_hinges.size();
  report["chain_depth"] = chain_depth(motion.linkage);
  report["waypoints"] = motion.path.waypoints.size();
  report["has_motion"] = motion.file.path.has_value();
  if (!motion.file.path && !motion.chain)
    session.say("the file holds no motion: shown as if all creases arrived together");
  std::vector<std::string> contents;
  for (const std::string& path : outputs) contents.push_back(bytes_for(path, motion, args, session));
  for (std::size_t i = 0; i < outputs.size(); ++i) session.write(outputs[i], contents[i]);
  return kDone;
}

}  // namespace

Job export_job() {
  const auto args = std::make_shared<ExportArgs>();
  return Job("export", "Write a net or a motion as animation, robot model, table, page, picture or mesh")
      .example("plico export bird.fold -o bird.html", "a page with the folding net, opens offline")
      .example("plico export bird.fold -o bird.glb -o bird.png --at 0.5", "an animation, and a picture half way")
      .example("plico export bird.fold -o bird.gif -o half.obj --at 0.5", "a film, and the shape half way as a mesh")
      .example("plico export bird.fold -o bird.urdf -o bird.xml -o bird.csv", "ROS, MuJoCo, and the angles as a table")
      .example("plico export crane.cp -o crane.fold -o crane.svg",
               "a crease pattern as FOLD, and for Origami Simulator")
      .example("plico export miura.ori.json --trajectory miura.trj.json -o miura.fold",
               "a motion of the dissertation's author, to be verified")
      .example("plico export motion.fold -o motion.angles.svg", "fold angles against time, as a figure")
      .positional(
          "file",
          "net, crease pattern or motion: FOLD, .cp, .opx, .ori, .ori.json or SVG in Origami Simulator's colours",
          args->file)
      .option("--trajectory", "FILE", "the motion of an .ori or .ori.json file: .trj or .trj.json", args->trajectory)
      .option("--title", "TEXT", "name shown on the page and given to the robot; the file's name by default",
              args->title)
      .choice("--up", "axis of the mesh along which pages and pictures let the model stand; sheet: as the net lies",
              args->up, {"auto", "y", "z", "sheet"})
      .option("--at", "TIME", "moment of a picture, or of a mesh: 0 flat, 1 folded", args->at, {0, 1})
      .option("--picture-width", "PIXELS", "of a picture, at least 16; 0: 1200, of a GIF 600", args->width, {0, 8192})
      .option("--picture-height", "PIXELS", "of a picture, at least 16; 0: three quarters of its width", args->height,
              {0, 8192})
      .angle("--azimuth", "camera of a picture, around the sheet", args->azimuth)
      .angle("--elevation", "camera of a picture, above the sheet's plane", args->elevation)
      .flag("--transparent", "a picture without background and shadow", args->transparent)
      .choice("--unit", "of a robot model: what one unit of the file measures; none: what the file says, or 1 mm",
              args->unit, {"none", "mm", "cm", "m", "in"})
      .length("--longest", "of a robot model: longest side when folded; else a unit is what the file says, or 1 mm",
              args->longest_mm, above(0))
      .option("--seconds", "SECONDS", "how long an animation or a trajectory lasts", args->seconds, above(0))
      .option("--grammage", "G_PER_M2", "mass of the sheet in a robot model", args->grams_per_square_metre, above(0))
      .option("--sheet-thickness", "MM", "thickness of panels in a robot model when the linkage has none",
              args->sheet_thickness_mm, above(0))
      .action([args](Session& session) { return export_file(*args, session); });
}

}  // namespace plico::jobs
