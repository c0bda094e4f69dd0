// Judges disjoint convex shells from scratch: convex, disjoint, inside their hulls, as much volume as claimed, touching
// where they claim to touch. Shares no code with the search for planes (folder convex).
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "plico/base/run.h"
#include "plico/geom/convex3.h"
#include "plico/mesh/soup.h"
#include "plico/verify/net.h"

namespace plico {

// What is claimed of a shape whose parts are given by their points.
struct ShellsClaim {
  struct Shell {
    PolygonSoup surface;           // triangles, counter-clockwise seen from outside
    std::vector<Vec3> in_hull_of;  // the points in whose hull it lies
  };
  struct Contact {
    int first = 0, second = 0;  // shells
    Plane plane;                // has the first strictly below, the second strictly above
    std::vector<Vec3> polygon;  // where they touch; may be empty
  };
  std::vector<std::vector<Vec3>> parts;  // the points of every part of the shape, nested ones too
  std::vector<Shell> shells;
  std::vector<Contact> contacts;
  double loss = 0;  // [Xi17] eq. 5.8: volume of the union of the hulls of `parts` that no shell fills, as a share
};

struct ShellsCheckOptions {
  double tolerance = 1e-8;          // of the diagonal: how far a shell may stick out of its hull
  double contact_tolerance = 1e-6;  // of the diagonal: how far a contact may be off its shells
  int samples = 100'000;            // points in the boxes of the hulls, to estimate the loss
  std::uint64_t seed = 1;
};

struct ShellsVerdict {
  int shells = 0, triangles = 0;
  long pairs = 0;               // of shells that were shown to be disjoint
  long plane_tests = 0;         // exact decisions of the side of a plane on which a point lies
  double loss = 0;              // estimated from samples
  double loss_error = 0;        // four standard deviations of the estimate
  std::vector<Defect> defects;  // empty when the claim holds; of one kind the first few and a count
  bool complete = true;         // false when the run was over before every check was done

  bool valid() const { return complete && defects.empty(); }
};

// Checks that
//   - every shell is a closed surface of genus 0 in one piece with no reflex edge, exactly: so it is convex;
//   - for every two shells the plane claimed between them parts them, or an axis where none is, exactly;
//   - every shell lies in its hull, and every contact's corners lie on both of its shells, within the tolerances;
//   - the claimed loss is within the error of an estimate from random points.
// Never throws for wrong shells. O(pairs * points + samples * facets).
ShellsVerdict verify_shells(const ShellsClaim& claim, const ShellsCheckOptions& options = {}, const Run& run = {});

// What is claimed of shells that were remeshed: those of `before`, in its order, are inside those of `after`.
struct RemeshClaim {
  const ShellsClaim& before;
  const ShellsClaim& after;  // its in_hull_of, parts and loss are not looked at
  double max_growth = 0;     // of the volume of each shell, as a share of it
};

// Checks that every new shell is convex and every two are disjoint, exactly as verify_shells() does; that contacts lie
// on both of their shells; that every point of an old shell is in the new one within the tolerance; that its volume did
// not shrink, beyond rounding, nor grow by more than max_growth. Never throws for wrong shells. O(pairs * points).
ShellsVerdict verify_remeshed_shells(const RemeshClaim& claim, const ShellsCheckOptions& options = {},
                                     const Run& run = {});

}  // namespace plico
