// Where to cut a mesh so that its parts mean something and fold.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "plico/base/run.h"
#include "plico/segment/wishes.h"
#include "plico/workflow/kit.h"

namespace plico {

enum class SegmentMethod { Necks, Clusters, Random };
enum class Symmetry { Auto, On, Off };           // where there is a mirror plane; there must be one; never
enum class PartsWish { Auto, Fewest, Exactly };  // cut at necks; cut only what fails; as many as are asked for

// Every net, turned as may be, is to fit a rectangle when printed.
struct PageFit {
  Vec2 room = Vec2::Zero();  // millimetres
  double scale = 1;          // millimetres per unit of the mesh
};

struct SegmentOptions {
  SegmentMethod method = SegmentMethod::Necks;
  PartsWish wish = PartsWish::Auto;
  int parts = 0;                       // for Exactly, in [components, faces]
  double neck = 0.8;                   // Auto: no cut scores this or more (segment/necks.h); above 0
  int max_parts = 12;                  // Auto: of the cuts at necks, more only where parts fail; at least 1
  double min_area = 0.008;             // of a part cut off at a neck, as a share of the mesh; in [0, 0.5]
  Symmetry symmetric = Symmetry::Off;  // left and right alike; for necks, without wishes for faces
  FaceWishes faces;                    // that stay together or come apart; for necks
  std::optional<PageFit> page;         // parts that do not fit are cut on, unless the number of parts is given
  ProvePartOptions prove;
};
void check(const SegmentOptions& options);  // throws InvalidOption
// "auto", "fewest" or a number, as users write it. Throws InvalidOption.
void set_wish(SegmentOptions& options, const std::string& word);

// Parts that fold: first what certainly fails is cut (faces that run through each other), then necks, as the wish says;
// every part is proven, parts that fail are joined to a neighbour or split, parts that fit no page are split, and split
// ones joined again while that is proven and fits. A face that fits no page by itself is told in the notes. A run that
// is over leaves what there is, with parts that are not proven. Throws InvalidOption when there cannot be so many
// parts, or for faces that cannot be kept together, InvalidInput ("segment/not-symmetric") when there must be a mirror
// plane and is none.
Kit segment_mesh(const Mesh& mesh, const SegmentOptions& options = {}, const Run& run = {});

}  // namespace plico
