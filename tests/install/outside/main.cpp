#include <cstdio>

#include "plico/base/version.h"
#include "plico/geom/predicates.h"
#include "plico/mesh/measures.h"

int main() {
  plico::PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.add_face({0, 2, 1});
  soup.add_face({0, 1, 3});
  soup.add_face({1, 2, 3});
  soup.add_face({2, 0, 3});
  const plico::Mesh tetrahedron(soup);
  std::printf("plico %s: volume %.6f, orientation %d\n", plico::version().c_str(), plico::volume(tetrahedron),
              plico::orient2d({0, 0}, {1, 1}, {3, 3}));
}
