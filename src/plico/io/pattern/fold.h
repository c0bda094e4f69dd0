// FOLD 1.2 (https://github.com/edemaine/fold), the one file format that carries a sheet from command to command: a net,
// a crease pattern, a strip or a motion. Degrees in the file, radians in the value.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plico/fold/face_order.h"
#include "plico/fold/folding_path.h"
#include "plico/fold/unfolding.h"

namespace plico {

// A piece of a kit, one part of the net, which folds by itself.
struct FoldPiece {
  std::string title;                // what it is called; may be empty
  std::optional<FoldingPath> path;  // its own motion: fold angles of its hinges, in the order of the whole linkage
  std::vector<std::vector<Vec3>> points;  // its vertices in space for every waypoint, in the order of the sheet
  std::vector<std::pair<std::string, std::string>> other;  // keys of its frame that mean nothing to us
};

// Everything a .fold file says. JSON that is not ours is kept as text, so that reading and writing loses nothing.
struct FoldFile {
  // The flat sheet (the key frame). mesh_face and mesh_vertex are empty when it came from no mesh; mesh_edge is not in
  // the file (attach_mesh finds it); mate is empty when the file names no mates; part is always filled.
  Unfolding net;
  std::string unit = "unit";  // "mm" once a physical size is set

  std::vector<Vec3> folded;  // n x 3, the net vertices in the folded form; empty when there is none

  // The motion: fold angles of the hinges, in the order of make_linkage(net.sheet, ...), and for every waypoint the net
  // vertices in space (n x 3).
  std::optional<FoldingPath> path;
  std::vector<std::vector<Vec3>> path_points;
  std::vector<FaceOrder> end_orders;  // faceOrders of its last waypoint, where the motion of one piece ends flat

  std::vector<FoldPiece> pieces;  // of a kit, one for each part of the net; files of one piece have none

  std::string report;  // plico:report, one JSON object; empty when there is none

  // Keys of the key frame that mean nothing to us, with their values as JSON text, ascending; and the frames that are
  // neither our folded form nor our motion, each one JSON object.
  std::vector<std::pair<std::string, std::string>> other;
  std::vector<std::string> other_frames;

  std::vector<std::string> notes;  // what reading assumed, one sentence each; not written
};

// What a file claims, and so what there is to verify about it.
enum class FoldKind { Net, Motion, CreasePattern };
FoldKind kind(const FoldFile& file);

// The file of an unfolding; its folded form is the mesh itself.
FoldFile fold_file(const Mesh& mesh, const Unfolding& unfolding);
FoldFile fold_file(const CreasePattern& sheet);

// The sheet that a motion folds takes the place of the one drawn, as when its panels were cut or its vertices moved.
// Seams, pieces and the motion of the old one go.
void set_sheet(FoldFile& file, const CreasePattern& sheet);

// Sets the motion and computes where it takes the vertices; the roots of `linkage`, made from the file's sheet, stay in
// their flat places. Of a kit every piece gets its share.
void set_path(FoldFile& file, const Linkage& linkage, const FoldingPath& path);

// The mesh that the folded form of a net shows: face mesh_face[f] and vertex mesh_vertex[v] of the mesh it came from.
// Throws InvalidInput when the file has no folded form, no mesh numbers, or they do not make a mesh.
Mesh folded_mesh(const FoldFile& file);

// Fills net.mesh_edge from the mesh numbers. Throws InvalidInput when the net cannot be of this mesh.
void attach_mesh(Unfolding& net, const Mesh& mesh);

// The same value gives the same bytes: fixed key order, shortest numbers that read back the same, lines of about 120
// columns. A value that was read is written back as it was, number for number. O(size).
std::string write_fold(const FoldFile& file);

// Reads any FOLD 1.0 to 1.2 file that holds a flat sheet: in its key frame, or else in the first frame that is flat.
//   - Frames may inherit from each other.
//   - Missing faces are the faces of the planar graph, missing edges the sides of the faces.
//   - A missing assignment follows from the fold angle, a missing fold angle from the assignment (mountain and valley
//     without an angle are folded flat, -180 and 180 degrees). Letters B M V F U C J.
//   - Faces of files that are not ours may be clockwise; they are turned over.
// Throws InvalidInput ("fold/...") with the key and index at fault. `name` is for messages.
FoldFile read_fold(std::string_view bytes, const std::string& name = "input");

}  // namespace plico
