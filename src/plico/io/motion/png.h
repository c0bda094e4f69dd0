// Still pictures of a linkage, drawn in memory: no display, no graphics card, the same pixels on every machine.
#pragma once
#include <string>
#include <vector>

#include "plico/base/picture.h"
#include "plico/fold/linkage.h"
#include "plico/io/text/png.h"

namespace plico {

struct Camera {
  double azimuth = radians(-35);   // around +z, from -y
  double elevation = radians(28);  // above the sheet's plane
  double field_of_view = radians(24);
};

struct PictureOptions {
  int width = 1200, height = 900;  // pixels, in [16, 8192]
  Camera camera;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // of the whole, before it is looked at
  bool transparent = false;                            // no background and no shadow on the ground
  // What must fit into the picture, so that stills of one motion share one scale; empty: the configuration itself.
  std::vector<Configuration> frame;
  std::vector<Vec3> room = {};  // points that must fit as well, after the turn
  // A motion of every panel after it is folded, to show pieces of a kit where they belong; empty: none.
  std::vector<Pose> home = {};
  std::vector<Color> colors = {};  // of the fronts of panels; empty: one a piece
};

// Panels seen in perspective: front and back in their own colours, creases and sides as lines, a soft shadow on the
// ground. Rendered at three times the size with a depth buffer, then averaged. O(pixels + panels). Throws InvalidInput
// beyond the limits of a hinge.
Picture render(const Linkage& linkage, const Configuration& config, const PictureOptions& options = {});

inline std::string render_png(const Linkage& linkage, const Configuration& config, const PictureOptions& options = {}) {
  return write_png(render(linkage, config, options));
}

}  // namespace plico
