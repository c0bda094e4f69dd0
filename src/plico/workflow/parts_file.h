// A mesh in parts as one FOLD file: the nets of all parts, each with its motion, and the keys plico:parts,
// edges_plico:seam and plico:joints.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "plico/fabricate/fabricate.h"
#include "plico/io/pattern/fold.h"
#include "plico/verify/parts.h"
#include "plico/workflow/kit.h"

namespace plico {

// One object a part: id, name, faces (of the mesh), area, pieces (numbers in faces_plico:part), size (of its net, as
// laid out), neighbors with the length of their seams, step of assembly, proven, motion, and mirror (the part that is
// its image) when that was asked for. Units are the mesh's.
nlohmann::json parts_json(const Mesh& mesh, const Kit& result);

// The nets side by side, folded form and all; frames of every piece with its motion, where that is proven. Numbers of
// seams are equal on both edges that are glued.
FoldFile parts_file(const Mesh& mesh, const Kit& result);

// The net of one part with its motion; its mesh numbers are those of the part.
FoldFile part_motion_file(const ProvenPart& part);

// What the parts are called on paper, in the order of the net's parts: a name of one or two characters is its id,
// longer ones get a letter; a part in several pieces, "A.1", "A.2".
std::vector<PartTitle> part_titles(const std::vector<std::string>& names, const std::vector<std::vector<int>>& pieces);

// The number of every sheet edge that is glued to another part, 0 of others: those of the key edges_plico:seam.
std::vector<int> seams_of(const Mesh& mesh, const Kit& kit);

// The joints that a file tells of, judged: throws InvalidInput with the first defect that verify_joints finds, and
// "fold/joints" for a part that there is not.
std::vector<Joint> joints_of(const PartsClaim& claim, const Mesh& mesh);

// What a file says about its parts; nothing when it says nothing. Throws InvalidInput ("fold/parts") when it cannot be
// read.
std::optional<PartsClaim> parts_claim(const FoldFile& file);

}  // namespace plico
