// For read_fold: the frames of a FOLD file as JSON, with messages that name the key and the entry at fault, and what is
// read from one frame or from all.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plico/io/pattern/fold.h"

namespace plico::fold_json {

using Json = nlohmann::json;

// Throws InvalidInput "fold/CODE".
[[noreturn]] void fail(const std::string& code, const std::string& message, const std::string& where,
                       const std::string& suggestion = {});

const Json* member(const Json& object, const char* key);  // null when there is none

// A frame with the frames it inherits from, nearest first. The JSON must outlive it.
class Frame {
 public:
  Frame(std::string where, std::vector<const Json*> chain) : where_(std::move(where)), chain_(std::move(chain)) {}

  const Json& own() const { return *chain_[0]; }

  // Places for messages: of a key, and of its entry i.
  std::string at(const std::string& key) const { return where_ + key; }
  std::string entry(const char* key, std::size_t i) const;

  // The value of a key, inherited or not; null when there is none.
  const Json* find(const char* key) const;

  // The array under a key, which must have `size` entries when that is not negative; null when there is none.
  const Json* array(const char* key, int size = -1) const;

  // One object with everything the frame says, standing on its own.
  Json flattened() const;

 private:
  std::string where_;
  std::vector<const Json*> chain_;
};

// Frame 0 is the key frame, frame i + 1 is file_frames[i].
std::vector<Frame> frames(const Json& root);

// Entry i under `key`: a finite number; an index in [0, limit).
double number(const Json& value, const Frame& frame, const char* key, std::size_t i);
int index(const Json& value, int limit, const Frame& frame, const char* key, std::size_t i);
std::vector<int> indices(const Frame& frame, const char* key, int size, int limit);

// n x 3, the coordinates of a frame; a missing z is 0. Empty when there are none.
std::vector<Vec3> points(const Frame& frame, int size = -1);

// The plane that a sheet lies in. Its front is seen from the positive side: from that of the axis which the plane is
// most nearly square to. x goes to the right (y where x cannot), so in the plane of x and z, as Origami Simulator
// writes it, z comes towards the reader.
struct SheetPlane {
  int axis = 2;  // square to x, y or z: the other two coordinates are taken as they are; -1: tilted
  Vec3 on{0, 0, 0}, right{1, 0, 0}, up{0, 1, 0};  // of a tilted one
  double off = 0;                                 // of the point that is farthest from it
};

// Nothing when no plane has all points within 1e-5 of their extent, which is what rounding to five digits does.
std::optional<SheetPlane> sheet_plane(const std::vector<Vec3>& points);
Vec2 in_plane(const Vec3& p, const SheetPlane& plane);

// The flat sheet that a frame holds, with its mesh numbers, parts and mates where it says so.
Unfolding read_net(const Frame& frame);

// Reads the folded form and the motion, or the pieces, for the sheet of `file`; returns the number of the first frame
// that is none of these.
std::size_t read_motion(const std::vector<Frame>& all, FoldFile& file);

}  // namespace plico::fold_json
