// Shapes made by formula: solids, spheres, tori, stars. All but open_grid() are closed; faces are planar up to rounding
// and counter-clockwise seen from outside. Numbers out of range throw InvalidOption naming value and range.
#pragma once
#include "plico/mesh/mesh.h"

namespace plico {

// Platonic solids, corners on the unit sphere.
PolygonSoup tetrahedron();
PolygonSoup cube();
PolygonSoup octahedron();
PolygonSoup dodecahedron();
PolygonSoup icosahedron();

// Cuts the corners of a closed mesh so deep that regular faces with `degree` sides become regular with twice as many.
// Truncating a Platonic solid gives an Archimedean one. O(n).
PolygonSoup truncated(const Mesh& solid, int degree);

// Cuts the corners down to the middles of the edges: cuboctahedron, icosidodecahedron. O(n).
PolygonSoup rectified(const Mesh& solid);

// A pyramid on every face of a closed mesh of regular faces, its slanted edges `leg` times as long as the base's, which
// must be more than the face's circumradius over its side. With the golden ratio a dodecahedron becomes the small, an
// icosahedron the great stellated dodecahedron. O(n).
PolygonSoup spiked(const Mesh& solid, double leg);

// n-gons, n >= 3, on the unit circle; sides of equal edges.
PolygonSoup prism(int n);
// The same between the unit circle and one of radius `top`, `height` above it, standing on y = 0. With top = 0 the
// sides meet in a point: a pyramid, or, for many sides, a cone.
PolygonSoup frustum(int n, double top, double height);
PolygonSoup house();  // a box with a ridged roof, standing on y = 0: 7 faces
PolygonSoup antiprism(int n);

// Every face of the icosahedron cut into frequency^2 triangles, corners moved out to the unit sphere: 20 frequency^2
// faces, frequency in [1, 1000].
PolygonSoup geodesic_sphere(int frequency);

// n quadrangles around the axis (z) and m around the tube, whose radius is `tube` in (0, 1); the middle of the tube
// runs on the unit circle. n, m >= 3; n m faces, planar trapezoids.
PolygonSoup torus(int n, int m, double tube = 0.4);

// The cube with n x n squares on every side, n >= 1; and an open sheet of n x m unit squares in the xy plane.
PolygonSoup quad_cube(int n);
PolygonSoup open_grid(int n, int m);

}  // namespace plico
