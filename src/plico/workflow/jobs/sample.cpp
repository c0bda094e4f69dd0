// plico sample: shapes made by the program itself.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/mesh/mesh_file.h"
#include "plico/shapes/named_shapes.h"
#include "plico/workflow/jobs/jobs.h"
#include "plico/workflow/jobs/read_mesh.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {
namespace {

struct SampleArgs {
  std::string name;
  bool list = false;
  ShapeOptions shape;
};

int list_shapes(Session& session) {
  nlohmann::json shapes = nlohmann::json::array();
  for (const NamedShape& shape : named_shapes()) {
    shapes.push_back(
        {{"name", shape.name}, {"description", shape.description}, {"has_face_count", shape.has_face_count}});
    session.print(fmt::format("{:<30}{}\n", shape.name, shape.description));
  }
  session.report()["shapes"] = std::move(shapes);
  return kDone;
}

int write_shape(const SampleArgs& args, Session& session) {
  const std::vector<std::string> outputs = session.outputs(args.name + ".obj");
  for (const std::string& path : outputs) output_format(path);
  ShapeOptions options = args.shape;
  if (options.variety != 0) options.seed = session.seed();
  const PolygonSoup shape = make_shape(args.name, options);
  for (const std::string& path : outputs) session.write(path, write_mesh(shape, output_format(path)));
  session.report()["shape"] = args.name;
  session.report()["vertices"] = shape.num_points();
  session.report()["faces"] = shape.num_faces();
  session.say(fmt::format("{}: {} vertices, {} faces", args.name, shape.num_points(), shape.num_faces()));
  return kDone;
}

int make_sample(const SampleArgs& args, Session& session) {
  if (args.list) return list_shapes(session);
  if (args.name.empty()) throw InvalidOption("which shape?", "plico sample --list");
  return write_shape(args, session);
}

}  // namespace

Job sample_job() {
  const auto args = std::make_shared<SampleArgs>();
  return Job("sample", "Make a shape to try things on: solids, stars, spheres, animals")
      .example("plico sample bird -o bird.obj", "a bird of 300 triangles")
      .example("plico sample dinosaur --faces 2000 -o dinosaur.ply", "as many faces as you like")
      .example("plico sample dog --variety 0.8 --seed 7 -o dog.obj", "another breed for every seed")
      .example("plico sample --list", "all names")
      .positional("name", "of the shape; --list shows all", args->name, false)
      .flag("--list", "show the name of every shape", args->list)
      .option("--faces", "N", "how many faces, or as near as the shape allows; 0: its usual number", args->shape.faces,
              {0, 1e6})
      .option("--variety", "X", "how much an animal's proportions stray; --seed picks one", args->shape.variety, {0, 1})
      .action([args](Session& session) { return make_sample(*args, session); });
}

}  // namespace plico::jobs
