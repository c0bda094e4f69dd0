#include "plico/workflow/origami_gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>

#include "plico/base/error.h"
#include "plico/fold/linkage.h"
#include "plico/io/pattern/pattern_file.h"
#include "plico/io/text/xml_text.h"
#include "plico/origami/settle.h"
#include "plico/workflow/plan_sheets.h"

namespace plico {
namespace {

using GalleryClock = std::chrono::steady_clock;

constexpr double kThumbnail = 200;  // width and height of the drawings
constexpr double kAtGoal = 0.98;    // within 2 % of it
constexpr double kHalfWay = 0.5, kSomeWay = 0.3;

const char* thumbnail_stroke(Assignment assignment) {
  switch (assignment) {
    case Assignment::Mountain:
      return "#d22";
    case Assignment::Valley:
      return "#24d";
    case Assignment::Boundary:
      return "#000";
    case Assignment::Cut:
      return "#0a0";
    default:
      return "#ccc";
  }
}

// Paper coordinates, y down, of points that then fill the thumbnail.
class ThumbnailFrame {
 public:
  explicit ThumbnailFrame(const std::vector<Vec2>& points) {
    for (const Vec2& p : points) box_.extend(p);
    const double size = box_.sizes().maxCoeff();
    scale_ = size > 0 ? (kThumbnail - 10) / size : 1;
  }
  std::string operator()(const Vec2& p) const {
    const Vec2 q = (p - box_.center()) * scale_;
    return fmt::format("{:.1f},{:.1f}", kThumbnail / 2 + q.x(), kThumbnail / 2 - q.y());
  }

 private:
  Eigen::AlignedBox2d box_;
  double scale_ = 1;
};

std::string svg_around(const std::string& body) {
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{0}\">{1}</svg>", kThumbnail,
                     body);
}

std::string pattern_thumbnail(const CreasePattern& sheet) {
  const ThumbnailFrame frame(sheet.vertices);
  std::string body;
  for (const Crease& e : sheet.edges)
    body += fmt::format("<polyline points=\"{} {}\" stroke=\"{}\" stroke-width=\".7\"/>", frame(sheet.vertices[e.a]),
                        frame(sheet.vertices[e.b]), thumbnail_stroke(e.assignment));
  return svg_around(body);
}

// Seen from the front and above, the farthest panels first.
std::string folded_thumbnail(const CreasePattern& sheet, const std::vector<Vec3>& points) {
  const Eigen::Matrix3d view = rotation(Vec3(1, 0, 0), radians(-40)) * rotation(Vec3(0, 0, 1), radians(20));
  std::vector<Vec2> seen;
  std::vector<double> depth;
  for (const Vec3& p : points) {
    const Vec3 q = view * p;
    seen.emplace_back(q.x(), q.y());
    depth.push_back(q.z());
  }
  const auto mean_depth = [&](int f) {
    double sum = 0;
    for (int v : sheet.faces[f]) sum += depth[v];
    return sum / static_cast<double>(sheet.faces[f].size());
  };
  std::vector<int> order(sheet.faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> far(order.size());
  for (int f : order) far[f] = mean_depth(f);
  std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return far[f] < far[g]; });
  const ThumbnailFrame frame(seen);
  std::string body;
  for (int f : order) {
    std::string corners;
    double area = 0;
    const std::vector<int>& face = sheet.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      corners += frame(seen[face[i]]) + " ";
      area += cross(seen[face[i]], seen[face[(i + 1) % face.size()]]);
    }
    body += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#555\" stroke-width=\".4\"/>", corners,
                        area > 0 ? "#f4efe2" : "#b9cbe0");
  }
  return svg_around(body);
}

std::optional<PatternFile> read_row(std::string_view bytes, const DrawingOptions& options, GalleryRow& row) {
  try {
    PatternFile pattern = read_pattern(bytes, row.file, options);
    row.read_notes = pattern.notes;
    return pattern;
  } catch (const InvalidInput& error) {
    row.refused = fmt::format("{}: {}", error.code(), error.what());
    if (!error.where().empty()) row.refused += " (" + error.where() + ")";
    return {};
  }
}

// What columns of their own tell already.
bool says_what_was_done(const std::string& note) {
  for (const char* done : {"settled: ", "cut by flat creases", "panels were cut by flat creases"})
    if (note.find(done) != std::string::npos) return true;
  return false;
}

void measure_row(const CreasePattern& drawn, const MotionOutcome& outcome, GalleryRow& row) {
  row.cut = !outcome.bends.empty();
  for (const double bend : outcome.bends) {
    row.bent += bend > 0;
    row.bend = std::max(row.bend, bend);
  }
  if (outcome.sheet)
    for (int v = 0; v < drawn.num_vertices(); ++v)
      row.settled = std::max(row.settled, (outcome.sheet->vertices[v] - drawn.vertices[v]).norm());
  if (row.settled > 0) row.settled_share = row.settled / shortest_edge(drawn);
  for (const std::string& note : outcome.notes)
    if (!says_what_was_done(note)) row.why_not.push_back(note);
}

void plan_row(FoldFile& file, const Linkage& linkage, const MotionOptions& options, const Run& run, GalleryRow& row) {
  const MotionOutcome outcome = plan_sheets(file.net.sheet, options, run);
  measure_row(file.net.sheet, outcome, row);
  row.planned = true;
  row.ending = outcome.ending;
  row.motion_notes = outcome.notes;
  row.proven = outcome.proven();
  row.progress = outcome.motions.empty() ? 0 : outcome.progress;
  if (outcome.motions.empty()) return;
  if (outcome.sheet) set_sheet(file, *outcome.sheet);
  set_path(file, outcome.sheet ? make_linkage(file.net.sheet) : linkage, outcome.motions.front().path);
  row.folded_svg = folded_thumbnail(file.net.sheet, file.path_points.back());
}

std::string joined(const std::vector<std::string>& notes, std::string_view between) {
  return fmt::format("{}", fmt::join(notes, between));
}

std::string quoted_cell(std::string text) {
  for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2)) text.insert(at, 1, '"');
  return '"' + text + '"';
}

std::string lines(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) html += (html.empty() ? "" : "<br>") + xml_text(sentence);
  return html;
}

const char* proof_word(const GalleryRow& row) {
  if (!row.planned || row.folded_svg.empty()) return "-";
  return row.proven ? "proven" : "not proven";
}

std::string settled_cell(const GalleryRow& row) {
  if (row.settled == 0) return "-";
  return fmt::format("{:.2g}<br>{:.2g} of the shortest edge", row.settled, row.settled_share);
}

std::string facets_cell(const GalleryRow& row) {
  if (!row.cut) return row.planned ? "whole panels" : "-";
  return fmt::format("{} of {} panels bend, by up to {:.3g}&deg;", row.bent, row.panels, degrees(row.bend));
}

// Green, yellow and red as the goals of the page count.
const char* row_class(const GalleryRow& row) {
  const double proven = row.proven ? row.progress : 0;
  return proven >= kAtGoal ? "goal" : proven >= kHalfWay ? "half" : proven >= kSomeWay ? "some" : "none";
}

std::string html_row(const GalleryRow& row) {
  const std::string reached = row.planned ? fmt::format("{:.4g} %", 100 * row.progress) : "-";
  const bool there = row.proven && row.progress >= 1;
  const std::string why = row.refused.empty() ? there ? "" : lines(row.why_not) : xml_text(row.refused);
  return fmt::format(
      "<tr><th>{}</th><td>{}</td><td>{}</td><td>{} vertices<br>{} creases<br>{} panels<br>{} sheet{}</td><td>{}</td>"
      "<td>{}</td><td>{}</td><td class=\"{}\"><b>{}</b><br>{}</td><td>{}</td><td>{:.2f} s</td></tr>\n",
      xml_text(row.file), row.pattern_svg, row.folded_svg, row.vertices, row.creases, row.panels, row.sheets,
      row.sheets == 1 ? "" : "s", lines(row.read_notes), settled_cell(row), facets_cell(row), row_class(row), reached,
      proof_word(row), why, row.seconds);
}

}  // namespace

GalleryRow gallery_row(const std::string& file, std::string_view bytes, const GalleryOptions& options, const Run& run) {
  GalleryRow row;
  row.file = file;
  std::optional<PatternFile> pattern = read_row(bytes, options.drawing, row);
  if (!pattern) return row;
  const CreasePattern& sheet = pattern->file.net.sheet;
  row.vertices = sheet.num_vertices();
  row.panels = sheet.num_faces();
  const std::vector<int> parts = parts_of(sheet);
  row.sheets = parts.empty() ? 0 : 1 + *std::max_element(parts.begin(), parts.end());
  row.pattern_svg = pattern_thumbnail(sheet);
  const auto start = GalleryClock::now();
  Run limited = run;
  if (options.seconds_each > 0) {
    const auto end =
        start + std::chrono::duration_cast<GalleryClock::duration>(std::chrono::duration<double>(options.seconds_each));
    limited.deadline = run.deadline ? std::min(*run.deadline, end) : end;
  }
  try {
    const Linkage linkage = make_linkage(sheet, pattern->file.net.mate);
    row.creases = linkage.num_hinges();
    plan_row(pattern->file, linkage, options.motion, limited, row);
  } catch (const InvalidInput& error) {
    row.refused = fmt::format("{}: {}", error.code(), error.what());
  }
  row.seconds = std::chrono::duration<double>(GalleryClock::now() - start).count();
  return row;
}

std::string gallery_page(const std::vector<GalleryRow>& rows) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Crease patterns</title>\n<style>"
      "body{font:14px sans-serif;margin:1em}table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:4px;"
      "vertical-align:top;text-align:left}td:nth-child(5),td:nth-child(9){min-width:14em;max-width:22em;font-size:12px}"
      "td:nth-child(6),td:nth-child(7){max-width:8em;font-size:12px}td:nth-child(4),b,td:last-child{white-space:nowrap}"
      "thead th{position:sticky;top:0;background:#fff}"
      ".goal{background:#d9f0d3}.half{background:#fdf6c8}.some{background:#fde3c8}.none{background:#f9d4d4}"
      "polyline{fill:none}</style></head>\n<body><h1>Crease patterns</h1><p>" +
      xml_text(gallery_summary(rows)) +
      "</p>\n<table><thead><tr><th>file</th><th>pattern</th><th>as far as it folds</th><th>counts</th><th>reading</th>"
      "<th>settled by</th><th>facets</th><th>of the way</th><th>why not "
      "farther</th><th>time</th></tr></thead>\n<tbody>\n";
  for (const GalleryRow& row : rows) page += html_row(row);
  return page + "</tbody></table></body></html>\n";
}

std::string gallery_csv(const std::vector<GalleryRow>& rows) {
  std::string csv =
      "file,read,vertices,creases,panels,sheets,settled,settled_of_shortest_edge,cut,bent,bend_deg,percent,proven,"
      "ending,"
      "seconds,reading,why_not,notes\n";
  for (const GalleryRow& row : rows)
    csv += fmt::format("{},{},{},{},{},{},{:.4g},{:.4g},{},{},{:.4g},{:.4f},{},{},{:.3f},{},{},{}\n",
                       quoted_cell(row.file), row.panels > 0 ? 1 : 0, row.vertices, row.creases, row.panels, row.sheets,
                       row.settled, row.settled_share, row.cut ? 1 : 0, row.bent, degrees(row.bend), 100 * row.progress,
                       row.proven ? 1 : 0, row.planned ? name(row.ending) : "refused", row.seconds,
                       quoted_cell(joined(row.read_notes, "; ")), quoted_cell(row.refused + joined(row.why_not, "; ")),
                       quoted_cell(joined(row.motion_notes, "; ")));
  return csv;
}

std::string gallery_summary(const std::vector<GalleryRow>& rows) {
  const auto count = [&](auto fits) { return std::count_if(rows.begin(), rows.end(), fits); };
  const auto proven_beyond = [&](double share) {
    return count([=](const GalleryRow& r) { return r.proven && r.progress >= share; });
  };
  return fmt::format(
      "{} patterns: {} read; proven: {} to the goal or within 2 % of it, {} at least half of the way, {} "
      "at least 30 %",
      rows.size(), count([](const GalleryRow& r) { return r.panels > 0; }), proven_beyond(kAtGoal),
      proven_beyond(kHalfWay), proven_beyond(kSomeWay));
}

}  // namespace plico
