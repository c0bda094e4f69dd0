// 3MF (https://3mf.io/specification, core 1.3): solids for printers, in millimetres.
#pragma once
#include <string>
#include <vector>

#include "plico/base/vec.h"
#include "plico/mesh/soup.h"

namespace plico {

// One solid at many places.
struct PlacedSolid {
  std::string name;
  PolygonSoup solid;         // closed, faces counter-clockwise seen from outside; millimetres
  std::vector<Pose> places;  // at least one
};

// The solid at each of its places, for formats that know no places.
PolygonSoup copies_of(const PlacedSolid& what);

// An archive with one object per solid and, when it stands at several places, one that puts it there; each is to be
// printed. Every double keeps its digits; polygons are cut into triangles. The same value gives the same bytes. Throws
// InvalidInput when there is nothing to print.
std::string write_3mf(const PlacedSolid& what);

}  // namespace plico
