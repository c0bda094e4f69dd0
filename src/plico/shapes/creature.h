// Animals as smooth unions of limbs, meshed with as many triangles as asked for: organic, non-convex shapes of our own.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "plico/mesh/soup.h"
#include "plico/shapes/smooth_body.h"

namespace plico {

enum class Animal { Bird, Dog, Fish, Dinosaur };
inline constexpr std::array kAnimals = {Animal::Bird, Animal::Dog, Animal::Fish, Animal::Dinosaur};
std::string_view name(Animal animal);  // "bird", ...

struct CreatureOptions {
  Animal animal = Animal::Bird;
  int faces = 300;         // in [100, 1000000]; an odd number is rounded down, closed triangle meshes are even
  double variety = 0;      // how much its proportions stray from the standard ones, in [0, 1]
  std::uint64_t seed = 1;  // which straying animal
};
void check(const CreatureOptions& options);  // throws InvalidOption

// About one to two units long, looking along +x, its left side towards +y, upright along z.
SmoothBody creature_body(const CreatureOptions& options);

// The limbs of that body; of a pair the left one, then the right one.
std::vector<Limb> creature_limbs(const CreatureOptions& options);

// The body's surface: closed, one component, genus 0, exactly the even number of triangles asked for. Same options,
// same mesh. About 10 microseconds a face, at least a tenth of a second.
PolygonSoup creature(const CreatureOptions& options = {});

}  // namespace plico
