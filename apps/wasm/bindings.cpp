// The only file that knows emscripten: Plico's jobs for JavaScript. Text goes in and out as JSON, files as bytes.
// What is thrown comes back as {"error": {code, message, where, suggestion, exit_code}}, so nothing crosses as an
// exception.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <nlohmann/json.hpp>

#include "editor.h"
#include "motion_player.h"
#include "plico/base/error.h"
#include "plico/base/version.h"
#include "plico/inflate/explicit.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/mesh/measures.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/remedy.h"

namespace plico {
namespace {

using emscripten::val;
using nlohmann::json;

val bytes_of(const std::string& text) {
  return val::global("Uint8Array")
      .new_(val(emscripten::typed_memory_view(text.size(), reinterpret_cast<const unsigned char*>(text.data()))));
}

std::string error_text(const std::exception& error, int exit_code) {
  json told{{"code", "internal"}, {"message", error.what()}, {"where", ""}, {"suggestion", ""}};
  if (const auto* ours = dynamic_cast<const Error*>(&error))
    told.update({{"code", ours->code()}, {"where", ours->where()}, {"suggestion", jobs::remedy(*ours, {})}});
  told["exit_code"] = exit_code;
  return json{{"error", told}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

template <class Work>
std::string guarded(Work work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    return error_text(error, jobs::kBadInput);
  } catch (const InvalidOption& error) {
    return error_text(error, jobs::kUsage);
  } catch (const FileError& error) {
    return error_text(error, jobs::kFile);
  } catch (const std::bad_alloc& error) {
    return error_text(error, jobs::kMemory);
  } catch (const std::exception& error) {
    return error_text(error, jobs::kInternal);
  }
}

class ToJavaScript final : public Progress {
 public:
  explicit ToJavaScript(const val& listener) : listener_(listener) {}
  void report(std::string_view phase, long done, long total, std::string_view note) override {
    listener_(std::string(phase), static_cast<double>(done), static_cast<double>(total), std::string(note));
  }

 private:
  const val& listener_;
};

std::string_view name(jobs::Tone tone) {
  switch (tone) {
    case jobs::Tone::Result:
      return "result";
    case jobs::Tone::Line:
      return "line";
    case jobs::Tone::Detail:
      return "detail";
    case jobs::Tone::Warning:
      return "warning";
  }
  return "line";
}

std::string outcome(const jobs::JobResult& result) {
  json messages = json::array();
  for (const jobs::Message& message : result.messages)
    messages.push_back({{"tone", name(message.tone)}, {"text", message.text}});
  return json{{"exit_code", result.exit_code}, {"report", json::parse(result.report)}, {"messages", messages}}.dump();
}

// Jobs and the files they read and write, kept in memory.
class Workspace {
 public:
  void put(const std::string& path, const std::string& bytes) { files_.files[path] = bytes; }
  bool has(const std::string& path) const { return files_.files.contains(path); }
  val get(const std::string& path) const { return has(path) ? bytes_of(files_.files.at(path)) : val::undefined(); }
  void remove(const std::string& path) { files_.files.erase(path); }
  std::string list() const {
    json names = json::array();
    for (const auto& [path, bytes] : files_.files) names.push_back(path);
    return names.dump();
  }

  // `values` is [[option, value], ...] as in jobs::run_job; `listener` a function or undefined.
  std::string run(const std::string& job, const std::string& values, const val& listener) {
    return guarded([&] {
      ToJavaScript progress(listener);
      Run run;
      if (!listener.isUndefined()) run.progress = &progress;
      return outcome(jobs::run_job(job, json::parse(values).get<jobs::Values>(), files_, run));
    });
  }

 private:
  jobs::MemoryFiles files_;
};

// A typed array of its own: what lies in the module's memory moves when that grows.
template <class T>
val array_of(const char* type, const std::vector<T>& values) {
  return val::global(type).new_(val(emscripten::typed_memory_view(values.size(), values.data())));
}

InflateOptions inflate_options(const std::string& text) {
  const json given = json::parse(text);
  InflateOptions options;
  options.method = InflateMethod::Explicit;
  options.pressure = given.value("pressure", options.pressure);
  options.max_growth = given.value("max_growth", options.max_growth);
  options.time_step = given.value("time_step", options.time_step);
  options.skin.constrained = given.value("constrained", true);
  options.skin.edge_stiffness = given.value("stiffness", options.skin.edge_stiffness);
  options.skin.stiff_edges = given.value("stiff_edges", options.skin.stiff_edges);
  options.skin.anchor_stiffness = given.value("anchors", options.skin.anchor_stiffness);
  if (given.contains("deep_angle_deg")) options.skin.deep_angle = radians(given["deep_angle_deg"].get<double>());
  options.max_steps = given.value("max_steps", options.max_steps);
  for (int v : given.value("keep_vertices", std::vector<int>())) options.keep_vertices.emplace_back(v);
  for (int f : given.value("keep", std::vector<int>())) options.keep.emplace_back(f);
  return options;
}

json edit_json(const Edit& edit) { return json::parse(write_edits({edit})).front(); }
Edit edit_of(const std::string& text) { return read_edits("[" + text + "]").front(); }

// An editor, and what it says in JSON. What failed leaves it as it was.
class EditorBinding {
 public:
  std::string open(const std::string& bytes, const std::string& name, const val& listener) {
    return with(listener, [&](const Run& run) {
      live_.reset();
      editor_.emplace(bytes, name, run);
      const Mesh& mesh = editor_->project().mesh;
      return json{{"name", editor_->project().name}, {"faces", mesh.num_faces()}, {"vertices", mesh.num_vertices()},
                  {"edges", mesh.num_edges()},       {"notes", editor_->notes()}, {"verdict", verdict(*editor_)}};
    });
  }
  val offsets() const { return array_of("Int32Array", editor_->project().mesh.soup().offsets); }
  val corner_edges() const {  // the edge at each corner, to the next
    const Mesh& mesh = editor_->project().mesh;
    std::vector<int> edges;
    for (int h = 0; h < mesh.num_halfedges(); ++h) edges.push_back(mesh.edge(HalfedgeId(h)));
    return array_of("Int32Array", edges);
  }
  val mesh_corners() const { return array_of("Float32Array", editor_->mesh_corners()); }
  val flat_corners() const { return array_of("Float32Array", editor_->flat_corners()); }
  val folded_corners(double time) { return array_of("Float32Array", editor_->folded_corners(time)); }
  val folds() const { return flags(editor_->project().forest.is_fold); }
  val locks() const { return flags(editor_->project().locked); }
  val parts() const { return array_of("Int32Array", editor_->net().part); }

  std::string edit_for(int edge) const {
    const std::optional<Edit> edit = editor_->edit_for(edge);
    return edit ? edit_json(*edit).dump() : "null";
  }
  std::string preview(const std::string& edit, val corners) const {
    return guarded([&] {
      const Editor other = editor_->after(edit_of(edit));
      corners.call<void>("push", array_of("Float32Array", other.flat_corners()));
      return verdict(other).dump();
    });
  }
  std::string apply(const std::string& edit) {
    return guarded([&] {
      const Edit inverse = editor_->apply(edit_of(edit));
      return json{{"inverse", edit_json(inverse)}, {"verdict", verdict(*editor_)}}.dump();
    });
  }
  std::string search(bool folds, const val& listener) {
    return with(listener, [&](const Run& run) { return json{{"edit", edit_json(editor_->search(folds, run))}}; });
  }
  void arrange() { editor_->arrange(); }

  // `options` as inflate_options() reads them; begins anew. What it then is, is told as by inflateStep().
  std::string inflate_begin(const std::string& options) {
    return guarded([&] {
      live_.reset();
      const InflateOptions read = inflate_options(options);
      check(editor_->project().mesh, read);
      live_.emplace(editor_->project().mesh, read);
      return inflation().dump();
    });
  }
  std::string inflate_step() {
    return guarded([&] {
      live_->advance();
      return inflation().dump();
    });
  }
  val inflated_corners() const {
    std::vector<float> corners;
    for (int v : editor_->project().mesh.soup().corners)
      for (double x : live_->result().points[v]) corners.push_back(static_cast<float>(x));
    return array_of("Float32Array", corners);
  }
  val hyperbolic_corners() const {  // of each corner whether its vertex is hyperbolic
    std::vector<unsigned char> corners;
    for (int v : live_->mesh().soup().corners) corners.push_back(static_cast<unsigned char>(live_->hyperbolic()[v]));
    return array_of("Uint8Array", corners);
  }
  val vertices() const { return array_of("Int32Array", editor_->project().mesh.soup().corners); }
  val inflated_bytes() const { return bytes_of(write_mesh(live_->mesh().soup(), MeshFormat::Obj)); }
  std::string motion(bool plan, const val& listener) {
    return with(listener, [&](const Run& run) {
      const Motion& motion = editor_->judge_motion(plan, run);
      return json{{"method", plico::name(motion.method)},
                  {"verdict", plico::name(motion.proof.verdict)},
                  {"from", motion.proof.from},
                  {"to", motion.proof.to},
                  {"panels", {motion.proof.panel_a, motion.proof.panel_b}}};
    });
  }
  val mesh_bytes() const { return bytes_of(write_mesh(editor_->project().mesh.soup(), MeshFormat::Obj)); }
  val fold_bytes() { return bytes_of(editor_->fold_bytes()); }
  val project_bytes() const { return bytes_of(write_project(editor_->project())); }

 private:
  json inflation() const {
    const Inflation& now = live_->result();
    const Mesh &mesh = live_->mesh(), &before = editor_->project().mesh;
    double most = 0;
    for (VertexId v : mesh.vertices()) most = std::max(most, (mesh.point(v) - before.point(v)).norm());
    return {{"steps", now.steps},
            {"hyperbolic", now.hyperbolic},
            {"hyperbolic_before", now.hyperbolic_before},
            {"growth", volume(mesh) / volume(before) - 1},
            {"largest_move", most},
            {"ended", live_->ended()},
            {"limit", plico::name(now.limit)}};
  }
  static json verdict(const Editor& editor) {
    const NetVerdict& v = editor.verdict();
    json overlaps = json::array(), defects = json::array();
    for (const OverlappingPair& pair : v.overlaps.listed) overlaps.push_back({pair.a, pair.b});
    for (const Defect& defect : v.defects) defects.push_back(defect.message);
    return {{"valid", v.valid()},
            {"parts", v.parts},
            {"overlaps", v.overlaps.count},
            {"pairs", overlaps},
            {"defects", defects}};
  }
  static val flags(const std::vector<char>& values) {
    return array_of("Uint8Array", std::vector<unsigned char>(values.begin(), values.end()));
  }
  template <class Work>
  static std::string with(const val& listener, Work work) {
    return guarded([&] {
      ToJavaScript progress(listener);
      Run run;
      if (!listener.isUndefined()) run.progress = &progress;
      return work(run).dump();
    });
  }

  std::optional<Editor> editor_;
  std::optional<ExplicitInflation> live_;  // of the editor's mesh
};

// A motion to look at. What failed leaves it as it was.
class PlayerBinding {
 public:
  std::string open(const std::string& bytes, const std::string& name) {
    return guarded([&] {
      player_.emplace(bytes, name);
      return json{{"faces", player_->offsets().size() - 1}, {"edges", player_->num_edges()}}.dump();
    });
  }
  val offsets() const { return array_of("Int32Array", player_->offsets()); }
  val corner_edges() const { return array_of("Int32Array", player_->corner_edges()); }
  val flat_corners() const { return array_of("Float32Array", player_->flat_corners()); }
  val corners_at(double time) const {  // none of nothing
    return array_of("Float32Array", player_ ? player_->corners_at(time) : std::vector<float>());
  }

 private:
  std::optional<MotionPlayer> player_;
};

}  // namespace
}  // namespace plico

EMSCRIPTEN_BINDINGS(plico) {
  using plico::Workspace;
  emscripten::function(
      "version", +[] { return std::string(plico::version()); });
  emscripten::function("describeJobs", &plico::jobs::describe_jobs);
  emscripten::class_<Workspace>("Workspace")
      .constructor<>()
      .function("put", &Workspace::put)
      .function("has", &Workspace::has)
      .function("get", &Workspace::get)
      .function("remove", &Workspace::remove)
      .function("list", &Workspace::list)
      .function("run", &Workspace::run);
  using Player = plico::PlayerBinding;
  emscripten::class_<Player>("MotionPlayer")
      .constructor<>()
      .function("open", &Player::open)
      .function("offsets", &Player::offsets)
      .function("cornerEdges", &Player::corner_edges)
      .function("flatCorners", &Player::flat_corners)
      .function("cornersAt", &Player::corners_at);
  using Editor = plico::EditorBinding;
  emscripten::class_<Editor>("Editor")
      .constructor<>()
      .function("open", &Editor::open)
      .function("offsets", &Editor::offsets)
      .function("cornerEdges", &Editor::corner_edges)
      .function("meshCorners", &Editor::mesh_corners)
      .function("flatCorners", &Editor::flat_corners)
      .function("foldedCorners", &Editor::folded_corners)
      .function("folds", &Editor::folds)
      .function("locks", &Editor::locks)
      .function("parts", &Editor::parts)
      .function("editFor", &Editor::edit_for)
      .function("preview", &Editor::preview)
      .function("apply", &Editor::apply)
      .function("search", &Editor::search)
      .function("arrange", &Editor::arrange)
      .function("motion", &Editor::motion)
      .function("inflateBegin", &Editor::inflate_begin)
      .function("inflateStep", &Editor::inflate_step)
      .function("inflatedCorners", &Editor::inflated_corners)
      .function("hyperbolicCorners", &Editor::hyperbolic_corners)
      .function("inflatedBytes", &Editor::inflated_bytes)
      .function("vertices", &Editor::vertices)
      .function("meshBytes", &Editor::mesh_bytes)
      .function("foldBytes", &Editor::fold_bytes)
      .function("projectBytes", &Editor::project_bytes);
}
