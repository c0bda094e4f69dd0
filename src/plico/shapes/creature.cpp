#include "plico/shapes/creature.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/mesh/self_intersections.h"
#include "plico/mesh/simplify.h"
#include "plico/shapes/isosurface.h"

namespace plico {
namespace {

// A limb of the standard animal; a pair stands on both sides of the plane y = 0.
struct Bone {
  Limb limb;
  bool is_pair = false;
};

Bone single(const Limb& limb) { return {limb, false}; }
Bone pair(const Limb& limb) { return {limb, true}; }
Limb flat(Limb limb, const Vec3& across, double thickness) {
  limb.across = across;
  limb.thickness = thickness;
  return limb;
}

// A dove in flight.
std::vector<Bone> bird() {
  const Vec3 up = Vec3::UnitZ(), wing(0, -0.3, 1), tip(0.1, -0.1, 1);
  return {single({{-0.22, 0, 0.00}, {0.14, 0, 0.02}, 0.115, 0.155}),
          single({{0.14, 0, 0.05}, {0.33, 0, 0.17}, 0.120, 0.085, 0.08}),
          single({{0.34, 0, 0.18}, {0.36, 0, 0.18}, 0.105, 0.100}),
          single({{0.42, 0, 0.17}, {0.56, 0, 0.13}, 0.050, 0.020, 0.03}),
          single(flat({{-0.25, 0, 0.01}, {-0.62, 0, 0.05}, 0.09, 0.17, 0.08}, up, 0.24)),
          pair(flat({{0.04, 0.06, 0.06}, {0.06, 0.42, 0.19}, 0.15, 0.165, 0.06}, wing, 0.25)),
          pair(flat({{0.06, 0.42, 0.19}, {-0.20, 0.90, 0.25}, 0.16, 0.060, 0.05}, tip, 0.34))};
}

std::vector<Bone> dog() {
  const Vec3 side = Vec3::UnitY();
  return {single({{-0.36, 0, 0.55}, {0.24, 0, 0.57}, 0.150, 0.185}),
          single({{0.26, 0, 0.62}, {0.42, 0, 0.84}, 0.140, 0.105, 0.08}),
          single({{0.44, 0, 0.88}, {0.48, 0, 0.87}, 0.130, 0.125, 0.04}),
          single({{0.52, 0, 0.85}, {0.72, 0, 0.80}, 0.085, 0.065, 0.04}),
          pair(flat({{0.42, 0.07, 0.96}, {0.38, 0.12, 1.13}, 0.062, 0.030, 0.03}, Vec3(1, 0, 0), 0.7)),
          pair({{0.24, 0.115, 0.48}, {0.25, 0.125, 0.07}, 0.090, 0.055, 0.05}),
          pair({{0.25, 0.125, 0.055}, {0.33, 0.125, 0.05}, 0.055, 0.050, 0.03}),
          pair({{-0.36, 0.105, 0.52}, {-0.34, 0.125, 0.29}, 0.120, 0.070, 0.05}),
          pair({{-0.34, 0.125, 0.29}, {-0.42, 0.125, 0.07}, 0.066, 0.052, 0.03}),
          pair({{-0.42, 0.125, 0.055}, {-0.34, 0.125, 0.05}, 0.055, 0.050, 0.03}),
          single(flat({{-0.47, 0, 0.62}, {-0.74, 0, 0.88}, 0.055, 0.035, 0.05}, side, 1))};
}

std::vector<Bone> fish() {
  const Vec3 side = Vec3::UnitY();
  return {single(flat({{-0.30, 0, 0.00}, {0.16, 0, 0.00}, 0.12, 0.245}, side, 0.55)),
          single(flat({{0.20, 0, -0.02}, {0.42, 0, -0.03}, 0.190, 0.085, 0.08}, side, 0.7)),
          single(flat({{-0.40, 0, 0.00}, {-0.68, 0, 0.23}, 0.06, 0.075, 0.06}, side, 0.42)),
          single(flat({{-0.40, 0, 0.00}, {-0.68, 0, -0.23}, 0.06, 0.075, 0.06}, side, 0.42)),
          single(flat({{0.12, 0, 0.19}, {-0.20, 0, 0.29}, 0.09, 0.055, 0.05}, side, 0.42)),
          single(flat({{-0.12, 0, -0.16}, {-0.26, 0, -0.26}, 0.06, 0.045, 0.05}, side, 0.45)),
          pair(flat({{0.14, 0.10, -0.09}, {-0.05, 0.26, -0.17}, 0.06, 0.085, 0.04}, Vec3(0.5, 1, 0.8), 0.4))};
}

// A two-legged hunter.
std::vector<Bone> dinosaur() {
  return {single({{-0.14, 0, 0.60}, {0.16, 0, 0.72}, 0.175, 0.150}),
          single({{0.18, 0, 0.77}, {0.32, 0, 1.00}, 0.125, 0.095, 0.08}),
          single({{0.34, 0, 1.04}, {0.42, 0, 1.05}, 0.115, 0.110, 0.04}),
          single({{0.44, 0, 1.03}, {0.68, 0, 0.99}, 0.100, 0.070, 0.04}),
          single({{-0.20, 0, 0.59}, {-0.55, 0, 0.54}, 0.145, 0.085, 0.08}),
          single({{-0.55, 0, 0.54}, {-1.05, 0, 0.66}, 0.085, 0.022, 0.05}),
          pair({{-0.10, 0.120, 0.55}, {0.06, 0.150, 0.34}, 0.135, 0.080, 0.05}),
          pair({{0.06, 0.150, 0.34}, {-0.08, 0.155, 0.12}, 0.076, 0.052, 0.03}),
          pair({{-0.08, 0.155, 0.065}, {0.14, 0.160, 0.050}, 0.060, 0.050, 0.03}),
          pair({{0.22, 0.100, 0.68}, {0.32, 0.150, 0.56}, 0.052, 0.040, 0.03}),
          pair({{0.32, 0.150, 0.56}, {0.42, 0.140, 0.60}, 0.038, 0.032, 0.02})};
}

std::vector<Bone> skeleton(Animal animal) {
  switch (animal) {
    case Animal::Bird:
      return bird();
    case Animal::Dog:
      return dog();
    case Animal::Fish:
      return fish();
    case Animal::Dinosaur:
      return dinosaur();
  }
  PLICO_ASSERT(false);
}

// Joints stay joints: the whole skeleton is stretched and bent by one smooth map, and only widths differ by bone.
void vary(std::vector<Bone>& bones, double variety, std::uint64_t seed) {
  const Rng all(seed);
  Rng build = all.stream(0);
  Vec3 stretch;
  for (int k = 0; k < 3; ++k) stretch[k] = 1 + 0.2 * variety * build.uniform(k == 1 ? 0 : -1, 1);  // legs stay apart
  const double bend = 0.3 * variety * build.uniform(-1, 1);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    Rng own = all.stream(i + 1);
    const double width = 1 + 0.12 * variety * own.uniform(-1, 1);
    Limb& limb = bones[i].limb;
    for (Vec3* joint : {&limb.from, &limb.to}) {
      *joint = joint->cwiseProduct(stretch);
      joint->z() += bend * joint->x() * joint->x();
    }
    limb.from_radius *= width;
    limb.to_radius *= width;
  }
}

Limb mirrored(Limb limb) {
  for (Vec3* v : {&limb.from, &limb.to, &limb.across}) v->y() = -v->y();
  return limb;
}

// A spacing at which the isosurface has about `faces` triangles, by the area found at a coarse one, or finer: no limb
// may fall between the lattice's points.
double spacing_for(const SmoothBody& body, int faces) {
  const double coarse = body.box().sizes().maxCoeff() / 64;
  const int found = isosurface(body, coarse).num_faces();
  return std::min(body.thinnest(), coarse * std::sqrt(static_cast<double>(found) / faces));
}

constexpr int kFewestFaces = 100, kMostFaces = 1'000'000;
constexpr int kEnoughForShape = 16'000;  // triangles before simplification that show every limb
// A collapse looks at the faces around it only, so that now and then a thin fin cuts itself; then the next is tried.
constexpr std::array kEvenness = {0.03, 0.05, 0.02, 0.08, 0.12, 0.01, 0.2};
constexpr double kSurplus = 3;  // triangles before simplification for one after it

}  // namespace

std::string_view name(Animal animal) {
  constexpr std::array<std::string_view, 4> kNames = {"bird", "dog", "fish", "dinosaur"};
  return kNames[static_cast<int>(animal)];
}

void check(const CreatureOptions& options) {
  if (options.faces < kFewestFaces || options.faces > kMostFaces)
    throw InvalidOption(fmt::format("faces = {} must be in [{}, {}]", options.faces, kFewestFaces, kMostFaces));
  require(options.variety >= 0 && options.variety <= 1, "variety", options.variety, "in [0, 1]");
}

std::vector<Limb> creature_limbs(const CreatureOptions& options) {
  check(options);
  std::vector<Bone> bones = skeleton(options.animal);
  if (options.variety > 0) vary(bones, options.variety, options.seed);
  std::vector<Limb> limbs;
  for (const Bone& bone : bones) {
    limbs.push_back(bone.limb);
    if (bone.is_pair) limbs.push_back(mirrored(bone.limb));
  }
  return limbs;
}

SmoothBody creature_body(const CreatureOptions& options) { return SmoothBody(creature_limbs(options)); }

PolygonSoup creature(const CreatureOptions& options) {
  const SmoothBody body = creature_body(options);
  const int fine = std::max(kEnoughForShape, static_cast<int>(kSurplus * options.faces));
  const Mesh surface(isosurface(body, spacing_for(body, fine)));
  PolygonSoup soup;
  for (double evenness : kEvenness) {
    soup = simplified(surface, {.faces = options.faces, .evenness = evenness});
    if (self_intersections(soup, 1).empty()) break;
  }
  return soup;
}

}  // namespace plico
