// What it costs to judge a net from scratch, beside laying it flat once and beside writing and reading its file.
// usage: bench_verify [MESH...] [--json FILE]    (without meshes: grids of 1,000 to 100,000 faces)
#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <numeric>

#include "plico/io/mesh/mesh_file.h"
#include "plico/io/pattern/fold.h"
#include "plico/io/text/file.h"
#include "plico/verify/net.h"

namespace {

using namespace plico;

// A wavy sheet of 2 n^2 triangles.
Mesh wavy_grid(int n) {
  PolygonSoup soup;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) soup.points.emplace_back(x, y, std::sin(0.3 * x) * std::cos(0.2 * y));
  const auto id = [&](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      soup.add_face({id(x, y), id(x + 1, y), id(x + 1, y + 1)});
      soup.add_face({id(x, y), id(x + 1, y + 1), id(x, y + 1)});
    }
  return Mesh(soup);
}

// The tree that takes edges in their order: long rows, which overlap here and there.
FoldForest first_tree(const Mesh& mesh) {
  std::vector<int> root(mesh.num_faces());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int f) {
    while (root[f] != f) f = root[f] = root[root[f]];
    return f;
  };
  FoldForest forest{std::vector<char>(mesh.num_edges(), 0)};
  for (EdgeId e : mesh.edges()) {
    if (mesh.is_boundary(e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    const int a = find(mesh.face(h)), b = find(mesh.face(mesh.twin(h)));
    if (a == b) continue;
    root[a] = b;
    forest.is_fold[e] = 1;
  }
  return forest;
}

// Seconds of the fastest of three calls.
template <class Work>
double seconds(Work work) {
  double best = INFINITY;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

std::string row(const std::string& name, const Mesh& mesh) {
  const FoldForest forest = first_tree(mesh);
  Unfolding net;
  NetVerdict verdict;
  std::string bytes;
  const double lay = seconds([&] { net = lay_flat(mesh, forest); });
  net.part = parts_of(net.sheet);
  const double verify = seconds([&] { verdict = verify_net(net, mesh); });
  const double write = seconds([&] { bytes = write_fold(fold_file(mesh, net)); });
  const double read = seconds([&] { read_fold(bytes); });
  fmt::print("{:24} {:8} {:9.4f} {:9.4f} {:9} {:9.1e} {:9.4f} {:9.4f} {:7.1f}\n", name, mesh.num_faces(), lay, verify,
             verdict.overlaps.count, verdict.closing_error, write, read, static_cast<double>(bytes.size()) / 1e6);
  return fmt::format(
      R"({{"mesh":"{}","faces":{},"lay_seconds":{},"verify_seconds":{},"overlaps":{},"closing_error":{},"write_seconds":{},"read_seconds":{},"bytes":{}}})",
      name, mesh.num_faces(), lay, verify, verdict.overlaps.count, verdict.closing_error, write, read, bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> meshes;
  std::string json_file;
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--json" && i + 1 < argc)
      json_file = argv[++i];
    else
      meshes.emplace_back(argv[i]);
  }
  fmt::print("{:24} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}\n", "mesh", "faces", "lay s", "verify s",
             "overlaps", "closing", "write s", "read s", "MB");
  std::string rows;
  const auto add = [&](const std::string& line) { rows += (rows.empty() ? "" : ",\n") + line; };
  for (const std::string& path : meshes) add(row(path.substr(path.find_last_of('/') + 1), load_mesh(path)));
  if (meshes.empty())
    for (int n : {22, 71, 224}) add(row(fmt::format("wavy grid {0}x{0}", n), wavy_grid(n)));
  if (!json_file.empty()) write_file(json_file, "[\n" + rows + "\n]\n", true);
}
