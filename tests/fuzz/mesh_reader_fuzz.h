// What every mesh reader must hold for any bytes at all.
#pragma once
#include <cstdint>
#include <string_view>

#include "plico/base/error.h"
#include "plico/io/mesh/obj.h"
#include "plico/mesh/check.h"
#include "plico/mesh/repair.h"

namespace plico {

// Either the bytes are refused as InvalidInput, or: every index is in range, every element has a place, check and
// repair work, what check calls usable becomes a Mesh, and what is written reads back.
template <class Read>
int fuzz_mesh_reader(const std::uint8_t* data, std::size_t size, Read&& read) {
  MeshSource source;
  try {
    source = read(std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const InvalidInput&) {
    return 0;
  }
  const PolygonSoup& soup = source.soup;
  PLICO_ASSERT(source.point_place.size() == soup.points.size());
  PLICO_ASSERT(static_cast<int>(source.face_place.size()) == soup.num_faces());
  for (int v : soup.corners) PLICO_ASSERT(v >= 0 && v < soup.num_points());
  for (int f = 0; f < soup.num_faces(); ++f)
    if (soup.face(f).size() > 200) return 0;  // cutting and checking one polygon is quadratic
  if (check_mesh(soup).usable()) Mesh{soup};
  const Repaired repaired = repair(soup);
  if (repaired.soup.num_faces() > 0) {
    PLICO_ASSERT(check_mesh(repaired.soup).usable());
    Mesh{repaired.soup};
  }
  const PolygonSoup again = read_obj(write_obj(repaired.soup)).soup;
  PLICO_ASSERT(again.points == repaired.soup.points && again.corners == repaired.soup.corners);
  return 0;
}

}  // namespace plico
