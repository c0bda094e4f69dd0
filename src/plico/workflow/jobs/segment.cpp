// plico segment: a mesh becomes named parts, each with a verified net and a proven motion.
#include <fmt/format.h>

#include <cctype>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "plico/base/error.h"
#include "plico/fabricate/fabricate.h"
#include "plico/io/mesh/face_groups.h"
#include "plico/mesh/measures.h"
#include "plico/segment/convexity.h"
#include "plico/segment/given.h"
#include "plico/verify/concavity.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/read_sheet.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/parts_file.h"
#include "plico/workflow/segment_mesh.h"

namespace plico::jobs {
namespace {

using nlohmann::json;

struct SegmentArgs {
  std::string mesh, by = "foldability", labels, motions, motion = "linear", repair = "safe", parts = "auto",
                    method = "necks", names, symmetric = "off", page;
  SizeOptions size;
  std::vector<std::string> keep, apart;
  SegmentOptions options;
  ConvexityOptions convexity;
};

PartMotion part_motion(const std::string& word) {
  static const std::map<std::string, PartMotion> kinds{{"linear", PartMotion::Linear},
                                                       {"uniform", PartMotion::Uniform},
                                                       {"any", PartMotion::Any},
                                                       {"none", PartMotion::None}};
  return kinds.at(word);
}

void check_usage(const SegmentArgs& args) {
  if (args.by == "labels" && args.labels.empty()) throw InvalidOption("--by labels needs --labels FILE");
  if (args.by != "labels" && !args.labels.empty()) throw InvalidOption("--labels needs --by labels");
  if (args.by != "foldability" && !(args.keep.empty() && args.apart.empty()))
    throw InvalidOption("--keep and --apart need --by foldability");
  if (args.page.empty() == args.size.is_given())
    throw InvalidOption("--page and --longest need each other: how large is the model, and what must a part fit?");
  if (!args.page.empty() && args.by != "foldability") throw InvalidOption("--page needs --by foldability");
  if (args.mesh == "-" && (args.names == "-" || args.labels == "-" || args.by == "groups"))
    throw InvalidOption("only one of two files, read once, can be standard input");
}

// A page asks for parts that fit it, less the margin and tabs as plico print has them by default.
std::optional<PageFit> page_fit(const SegmentArgs& args, const Mesh& mesh) {
  if (args.page.empty()) return std::nullopt;
  LayoutOptions layout;
  layout.page.size = paper_size(args.page);
  return PageFit{room_without_tabs(layout), scale_of(folded_shape(mesh), args.size)};
}

FaceWishes face_wishes(const SegmentArgs& args) {
  FaceWishes wishes;
  for (const std::string& text : args.keep) wishes.keep.push_back(face_list(text, "keep"));
  for (const std::string& text : args.apart) wishes.apart.push_back(face_list(text, "apart"));
  return wishes;
}

// Faces of the file are counted before any repair: labels and groups are about these.
Segmentation by_file_groups(const Mesh& mesh, const FaceGroups& groups) {
  if (static_cast<int>(groups.of_face.size()) != mesh.num_faces())
    throw InvalidInput("segment/labels",
                       fmt::format("there are {} labels for {} faces", groups.of_face.size(), mesh.num_faces()), {},
                       "give one label for each face of this mesh, and a mesh that needs no repair");
  return by_groups(mesh, groups.of_face, groups.names);
}

Segmentation parts_of(const Mesh& mesh, const SegmentArgs& args, Session& session) {
  if (args.by == "components") return by_components(mesh);
  if (args.by == "convexity") return by_labels(mesh, cut_by_convexity(mesh, args.convexity, session.run()));
  if (args.by == "labels") return by_file_groups(mesh, read_face_labels(session.read(args.labels), args.labels));
  return by_file_groups(mesh, read_obj_groups(session.read(args.mesh), args.mesh));
}

// Of the diagonal, by the judge.
double concavity(const Mesh& mesh, const Kit& result) {
  const double size = diagonal(mesh);
  return size > 0 ? concavity_bound(mesh, result.parts) / size : 0;
}

json report_of(const Mesh& mesh, const SegmentArgs& args, const Kit& result) {
  double seam = 0;
  for (EdgeId e : seams(mesh, result.parts)) seam += length(mesh, e);
  return {{"by", args.by},
          {"faces", mesh.num_faces()},
          {"num_parts", result.parts.num_parts()},
          {"num_proven", result.num_proven()},
          {"ending", name(result.ending)},
          {"seam_length", seam},
          {"seam_in_diagonals", diagonal(mesh) > 0 ? seam / diagonal(mesh) : 0},
          {"concavity", concavity(mesh, result)},
          {"net_valid", result.verdict.valid()},
          {"notes", result.notes},
          {"parts", parts_json(mesh, result)}};
}

std::string proof_text(const ProvenPart& part, const std::string& motion) {
  if (part.verdict.parts > 1)
    return fmt::format("net in {} pieces{}", part.verdict.parts,
                       part.proven_impossible ? ", as every tree overlaps" : "");
  if (motion == "none") return "net verified";
  if (part.net.sheet.num_faces() == 1) return "one panel";
  if (!part.crossing.empty()) return "net verified, the part runs through itself, so no motion can fold it";
  if (part.proven()) return fmt::format("net verified, {} motion proven free", name(part.motion->method));
  return part.proven_impossible ? fmt::format("net verified, no net of it has a free {} motion", motion)
                                : fmt::format("net verified, no free {} motion found", motion);
}

// The bound of --by convexity, as judged; up to the rounding of a depth.
bool keeps_bound(const SegmentArgs& args, const json& report) {
  return args.by != "convexity" || report["concavity"].get<double>() <= args.convexity.concavity + 1e-12;
}

std::string image_text(const Kit& kit, int part) {
  if (kit.mirror.empty() || kit.mirror[part] < 0) return "";
  if (kit.mirror[part] == part) return ", its own mirror image";
  return fmt::format(", the mirror image of {}", kit.parts.names[kit.mirror[part]]);
}

void say_parts(const Session& session, const SegmentArgs& args, const json& report, const Kit& result) {
  const int n = result.parts.num_parts();
  session.say(fmt::format("{} faces: {} {}, {} proven; seams {:.3g} diagonals", report["faces"].get<int>(), n,
                          n == 1 ? "part" : "parts", result.num_proven(), report["seam_in_diagonals"].get<double>()));
  if (args.by == "convexity")
    session.say(fmt::format("no vertex lies deeper below the hull of its part than {:.3g} diagonals",
                            report["concavity"].get<double>()));
  for (int i = 0; i < n; ++i)
    session.say(fmt::format("  {}: {} {}, {}", result.parts.names[i], result.part[i].net.sheet.num_faces(),
                            result.part[i].net.sheet.num_faces() == 1 ? "face" : "faces",
                            proof_text(result.part[i], args.motion) + image_text(result, i)));
  for (const std::string& note : result.notes) session.warn(note);
}

// One file a part, named after it; what no file name may hold becomes '_'.
void write_motions(const SegmentArgs& args, const Kit& result, Session& session) {
  if (args.motions.empty()) return;
  for (int i = 0; i < result.parts.num_parts(); ++i) {
    std::string stem = result.parts.names[i];
    for (char& c : stem)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    write_fold_files(part_motion_file(result.part[i]), {fmt::format("{}/{}-{}.fold", args.motions, i, stem)}, session);
  }
}

int segment_file(SegmentArgs& args, Session& session) {
  check_usage(args);
  args.options.prove = {.seed = session.seed(), .motion = part_motion(args.motion)};
  args.options.method = args.method == "clusters" ? SegmentMethod::Clusters
                        : args.method == "random" ? SegmentMethod::Random
                                                  : SegmentMethod::Necks;
  set_wish(args.options, args.parts);
  args.options.faces = face_wishes(args);
  args.options.symmetric = args.symmetric == "on"     ? Symmetry::On
                           : args.symmetric == "auto" ? Symmetry::Auto
                                                      : Symmetry::Off;
  check(args.options);
  check(args.convexity);
  const std::vector<std::string> outputs = fold_outputs(session);
  if (!args.motions.empty()) session.make_folder(args.motions);
  const Mesh mesh = read_mesh(args.mesh, args.repair, session);
  args.options.page = page_fit(args, mesh);
  check(args.options);
  Kit result = args.by == "foldability"
                   ? segment_mesh(mesh, args.options, session.run())
                   : make_kit(mesh, parts_of(mesh, args, session), args.options.prove, session.run());
  if (!args.names.empty()) name_parts(result.parts, session.read(args.names), args.names);
  const json report = report_of(mesh, args, result);
  session.report().update(report);
  say_parts(session, args, report, result);
  if (!result.verdict.valid() || !keeps_bound(args, report)) return kInternal;
  write_fold_files(parts_file(mesh, result), outputs, session);
  write_motions(args, result, session);
  return Session::exit_code(result.ending);
}

}  // namespace

Job segment_job() {
  auto args = std::make_shared<SegmentArgs>();
  Job job("segment", "Cut a mesh into named parts, each with a verified net and a proven motion");
  SegmentOptions& options = args->options;
  job.example("plico segment bird.obj -o bird.fold", "head, wings, legs: parts that come off at necks")
      .example("plico segment star.obj --parts fewest -o star.fold", "as few parts as are proven to fold")
      .example("plico segment dog.obj --by convexity -o dog.fold", "parts that are nearly convex, as few as may be")
      .example("plico segment robot.obj --by components -o robot.fold", "one part for each piece of the model")
      .example("plico segment dog.obj --by groups -o dog.fold", "the groups of an OBJ file, with their names")
      .example("plico segment dog.obj --by labels --labels dog.seg -o dog.fold", "one label a line and a face")
      .positional("mesh", "OBJ, OFF, STL or PLY file; - for standard input", args->mesh)
      .choice("--by", "what makes a part", args->by, {"foldability", "convexity", "components", "groups", "labels"})
      .option("--parts", "WISH",
              "auto: cut at every good neck; fewest: cut only what does not fold in one piece; or a number",
              args->parts)
      .choice("--method", "how the mesh is cut: necks, or clusters of the dissertation, or at random, to compare with",
              args->method, {"necks", "clusters", "random"})
      .option("--neck", "SCORE", "auto: cut where seam over area scores below this; more means more parts",
              options.neck, above(0))
      .option("--max-parts", "N", "auto: at most so many parts, unless parts fail", options.max_parts, at_least(1))
      .option("--min-area", "SHARE", "of the surface, in the smallest part cut off at a neck", options.min_area,
              {0, 0.5})
      .option("--concavity", "X",
              "for --by convexity: how deep a vertex may lie below the hull of its part, as a share of the diagonal",
              args->convexity.concavity, above(0))
      .choice("--symmetric", "left and right alike, on meshes with a mirror plane; auto: where there is one",
              args->symmetric, {"auto", "on", "off"})
      .option("--page", "SIZE", "cut on until each part fits a page, as A4, with margins of 10 mm and tabs of 5 mm",
              args->page)
      .length("--longest", "for --page: longest side of the finished model", args->size.longest)
      .option("--keep", "FACES", "these stay in one part, such as 3,17-20", args->keep)
      .option("--apart", "FACES", "no two of these are in one part", args->apart)
      .option("--names", "FILE", "lines of a face and a name: the part with this face is called so", args->names)
      .option("--labels", "FILE", "for --by labels: one number or word a line, for each face", args->labels)
      .choice("--motion", "what must be proven free of collision for each part, besides its net", args->motion,
              {"linear", "uniform", "any", "none"})
      .option("--motions", "DIR", "also write the net of each part with its motion into this folder", args->motions)
      .action([args](Session& session) { return segment_file(*args, session); });
  add_repair_option(job, args->repair);
  return job;
}

}  // namespace plico::jobs
