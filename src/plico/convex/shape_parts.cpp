#include "plico/convex/shape_parts.h"

#include <fmt/format.h>

#include <map>
#include <numeric>
#include <set>

#include "plico/base/error.h"
#include "plico/mesh/segmentation.h"
#include "plico/mesh/weld.h"

namespace plico {
namespace {

std::vector<int> component_of_faces(const PolygonSoup& soup) {
  std::vector<int> root = welded_points(soup.points);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  std::vector<int> component(soup.num_faces(), -1);
  for (int f = 0; f < soup.num_faces(); ++f)
    for (int v : soup.face(f)) root[find(v)] = find(soup.face(f)[0]);
  std::map<int, int> number;
  for (int f = 0; f < soup.num_faces(); ++f) {
    if (soup.face(f).empty()) continue;
    component[f] = number.try_emplace(find(soup.face(f)[0]), static_cast<int>(number.size())).first->second;
  }
  return component;
}

std::string unused_name(const std::string& name, std::set<std::string>& used) {
  const std::string stem = name.empty() ? "part" : name;
  std::string result = stem;
  for (int i = 2; !used.insert(result).second; ++i) result = fmt::format("{}-{}", stem, i);
  return result;
}

}  // namespace

std::vector<ShapePart> parts_by_components(const PolygonSoup& soup) {
  const std::vector<int> component = component_of_faces(soup);
  std::vector<std::string> names;
  for (int c : component)
    if (c == static_cast<int>(names.size())) names.push_back(part_name(c));
  return parts_by_groups(soup, component, names);
}

std::vector<ShapePart> parts_by_groups(const PolygonSoup& soup, const std::vector<int>& group_of_face,
                                       const std::vector<std::string>& names) {
  if (static_cast<int>(group_of_face.size()) != soup.num_faces())
    throw InvalidInput("shell/labels",
                       fmt::format("there are {} labels for {} faces", group_of_face.size(), soup.num_faces()), {},
                       "give one label for each face of this file");
  std::vector<std::set<int>> points(names.size());
  for (int f = 0; f < soup.num_faces(); ++f)
    for (int v : soup.face(f)) points[group_of_face[f]].insert(v);
  std::set<std::string> used;
  std::vector<ShapePart> parts;
  for (std::size_t g = 0; g < names.size(); ++g) {
    if (points[g].empty()) continue;
    ShapePart part{unused_name(names[g], used), {}};
    for (int v : points[g]) part.points.push_back(soup.points[v]);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace plico
