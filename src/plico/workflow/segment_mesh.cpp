// segment_mesh(): a first cut by the method asked for, proofs, and answers to what fails.
#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "plico/base/error.h"
#include "plico/geom/convex2.h"
#include "plico/geom/rectangle_fit.h"
#include "plico/mesh/measures.h"
#include "plico/segment/clusters.h"
#include "plico/segment/coarse.h"
#include "plico/segment/mirror.h"
#include "plico/segment/must_part.h"
#include "plico/segment/necks.h"
#include "plico/segment/rearrange.h"
#include "plico/segment/thickness.h"
#include "plico/unfold/flat_faces.h"
#include "plico/unfold/heuristics.h"
#include "plico/unfold/overlap.h"
#include "plico/workflow/segment_mesh.h"

namespace plico {
namespace {

using FacePair = std::pair<int, int>;

constexpr int kGivenParts = 10;           // of clusters and random parts, unless a number is asked for
constexpr int kMostForClusters = 20'000;  // faces: a matrix of 1.6 GB
constexpr int kTrials = 100;              // unfoldings that clusters learn from
constexpr int kSmallPiece = 60;  // faces: a failed part up to this size is offered to its neighbours before it is split

std::string list_of(const std::vector<FacePair>& pairs) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 5); ++i)
    text += fmt::format("{}{}-{}", i ? ", " : "", pairs[i].first, pairs[i].second);
  return text + (pairs.size() > 5 ? ", ..." : "");
}

struct Piece {
  std::vector<int> faces;  // ascending
  int origin = 0;          // the part it was cut from when that failed
  ProvenPart proof;
  bool whole = false;  // nothing of it can be cut off: it is one face, or its faces are kept together
  bool fits = true;    // the page

  bool sound() const { return proof.proven() && fits; }
};

class Segmenter {
 public:
  Segmenter(const Mesh& mesh, const SegmentOptions& options, const Run& run)
      : mesh_(mesh), options_(options), run_(run), graph_(mesh), apart_(pairs_apart(options.faces)) {
    hold_together(graph_, options.faces);
  }

  Kit run() {
    make_pieces(first_cut());
    if (options_.wish != PartsWish::Exactly) answer_failures();
    if (options_.wish != PartsWish::Exactly && options_.method == SegmentMethod::Necks) join_while_proven();
    return finish();
  }

 private:
  std::vector<int> first_cut() {
    if (options_.method == SegmentMethod::Necks) return necks_cut();
    if (options_.method == SegmentMethod::Clusters) learn();
    std::vector<int> part = components(mesh_).of_face;
    const int wanted = options_.wish == PartsWish::Exactly ? options_.parts : kGivenParts;
    // A mesh in several components has its parts in the largest.
    std::map<int, std::vector<int>> faces;
    for (FaceId f : mesh_.faces()) faces[part[f]].push_back(f);
    const auto largest = std::max_element(
        faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
    const int count = static_cast<int>(faces.size());
    const std::vector<int> cut = cut_by_method(largest->second, std::max(1, wanted - count + 1));
    for (std::size_t i = 0; i < cut.size(); ++i)
      if (cut[i] > 0) part[largest->second[i]] = count + cut[i] - 1;
    return part;
  }

  std::vector<int> necks_cut() {
    const std::vector<int> start = certain_cuts();
    check_kept(options_.faces, start);
    if (const auto images = images_to_keep(start)) return cut_mirrored(graph_, start, *images, neck_options(), run_);
    if (apart_.empty() && !options_.faces.any()) return cut_limbs_of(mesh_, graph_, neck_options(), run_);
    return cut_by_thickness(mesh_, graph_, cut_limbs(graph_, start, neck_options(), run_), neck_options(), run_);
  }

  // Of every face, when both sides are to be alike and can be.
  std::optional<std::vector<int>> images_to_keep(const std::vector<int>& start) {
    if (options_.symmetric == Symmetry::Off) return std::nullopt;
    images_ = mirror_images(mesh_);
    if (!images_ && options_.symmetric == Symmetry::On)
      throw InvalidInput("segment/not-symmetric", "no plane maps the mesh onto itself", {},
                         "leave --symmetric out, or use auto");
    if (!images_) return std::nullopt;
    const std::vector<int> partner = mirror_partners(start, *images_);
    if (std::count(partner.begin(), partner.end(), -1) == 0) return images_;
    notes_.emplace_back("what must come apart is not symmetric, so the parts are not");
    return std::nullopt;
  }

  // Clusters or random parts of connected faces.
  std::vector<int> cut_by_method(const std::vector<int>& faces, int k) {
    k = std::min(k, static_cast<int>(faces.size()));
    const std::uint64_t seed = Rng(options_.prove.seed).stream(cuts_made_++).next();
    if (options_.method == SegmentMethod::Random) return random_parts(graph_, faces, k, seed);
    return cluster(graph_, *foldability_, faces, k, seed);
  }

  // [Xi17] 4.2.1: what overlaps in steepest-edge trees of random directions.
  void learn() {
    const Rng rng(options_.prove.seed);
    const FlatFaces panels(mesh_);
    foldability_.emplace(
        mesh_, kTrials,
        [&](int i) {
          Rng own = rng.stream(i);
          const Vec3 direction = random_direction(own);
          FoldForest tree = lightest_forest(mesh_, dual_weights(mesh_, Heuristic::SteepestEdge, direction, own));
          std::vector<FacePair> overlaps = overlapping_pairs(panels, lay_panels(panels, tree));
          return UnfoldingTrial{std::move(tree.is_fold), std::move(overlaps)};
        },
        run_);
  }

  // Parts inside components, and apart what runs through itself.
  std::vector<int> certain_cuts() {
    std::vector<int> part = components(mesh_).of_face;
    if (options_.prove.motion != PartMotion::None) add_crossings();
    if (apart_.empty()) return part;
    return part_pairs(graph_, std::move(part), apart_);
  }

  void add_crossings() {
    run_.report("looking for faces that run through each other", 0);
    const std::vector<FacePair> crossings = crossing_faces(mesh_);
    if (crossings.empty()) return;
    notes_.push_back(fmt::format("one piece cannot fold: {} pairs of faces run through each other ({})",
                                 crossings.size(), list_of(crossings)));
    apart_.insert(apart_.end(), crossings.begin(), crossings.end());
  }

  NeckCutOptions neck_options() const {
    NeckCutOptions necks{.worst_score = options_.neck, .max_parts = options_.max_parts, .neck = {}};
    necks.neck.min_area = options_.min_area;
    if (options_.wish == PartsWish::Fewest) necks.max_parts = 1;
    if (options_.wish == PartsWish::Exactly) {
      necks.max_parts = options_.parts;
      necks.worst_score = std::numeric_limits<double>::infinity();
    }
    return necks;
  }

  ProvenPart prove(const std::vector<int>& faces, const Run& run) const {
    std::vector<FaceId> ids;
    for (int f : faces) ids.emplace_back(f);
    return prove_part(mesh_, ids, options_.prove, run);
  }

  void make_pieces(const std::vector<int>& part) {
    pieces_.resize(*std::max_element(part.begin(), part.end()) + 1);
    for (std::size_t f = 0; f < part.size(); ++f) pieces_[part[f]].faces.push_back(static_cast<int>(f));
    for (std::size_t p = 0; p < pieces_.size(); ++p) pieces_[p].origin = static_cast<int>(p);
    prove_from(0);
  }

  // Side by side, in any order: every proof stands alone.
  void prove_from(std::size_t first) {
    Run alone = run_;
    alone.threads = 1;
    alone.progress = nullptr;
    run_.report("proving parts", static_cast<long>(first), static_cast<long>(pieces_.size()));
    parallel_for(run_, static_cast<int>(pieces_.size() - first),
                 [&](int i) { pieces_[first + i].proof = prove(pieces_[first + i].faces, alone); });
    for (std::size_t i = first; i < pieces_.size(); ++i) {
      pieces_[i].fits = fits(pieces_[i].proof);
      if (!pieces_[i].sound()) failed_.insert(pieces_[i].faces);
    }
  }

  // No net has less area than its faces.
  bool may_fit(const std::vector<int>& faces) const {
    if (!options_.page) return true;
    double sum = 0;
    for (int f : faces) sum += area(mesh_, FaceId(f));
    return sum * options_.page->scale * options_.page->scale <= options_.page->room.prod();
  }

  bool fits(const ProvenPart& part) const {
    if (!options_.page) return true;
    std::vector<Vec2> corners;
    for (const Vec2& p : part.net.sheet.vertices) corners.emplace_back(options_.page->scale * p);
    return angle_that_fits(convex_hull(std::move(corners)), options_.page->room).has_value();
  }

  int first_failure() const {
    const auto at = std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& p) { return !p.sound() && !p.whole; });
    return at == pieces_.end() ? -1 : static_cast<int>(at - pieces_.begin());
  }

  void answer_failures() {
    for (int p = first_failure(); p >= 0 && !run_.over(); p = first_failure())
      if (!join_small(p) && !split(p)) pieces_[p].whole = true;
  }

  bool join_small(int p) {
    if (pieces_[p].proof.proven()) return false;  // it is too large
    if (options_.wish == PartsWish::Fewest || options_.method != SegmentMethod::Necks) return false;
    if (pieces_[p].faces.size() > kSmallPiece) return false;
    for (const auto& [cost, pair] : seams_by_cost())
      if ((pair.first == p || pair.second == p) && join(pair.first, pair.second)) return true;
    return false;
  }

  // One side of a cut in two: at the best neck, however small, or as the method has it; empty when all is kept
  // together.
  std::vector<int> side_of_cut(const std::vector<int>& faces) {
    std::vector<int> side;
    if (options_.method != SegmentMethod::Necks) {
      const std::vector<int> cut = cut_by_method(faces, 2);
      for (std::size_t i = 0; i < cut.size(); ++i)
        if (cut[i] == 1) side.push_back(faces[i]);
    }
    if (side.empty()) {  // clusters may be empty
      const std::optional<Neck> neck = best_neck(graph_, faces, {.min_area = 0});
      PLICO_ASSERT(neck.has_value() || !options_.faces.keep.empty());
      if (neck) side = neck->side;
    }
    return side;
  }

  bool split(int p) {
    if (pieces_[p].faces.size() == 1) return false;
    const std::vector<int> side = side_of_cut(pieces_[p].faces);
    if (side.empty()) return false;
    std::vector<int> rest;
    std::set_difference(pieces_[p].faces.begin(), pieces_[p].faces.end(), side.begin(), side.end(),
                        std::back_inserter(rest));
    const int origin = pieces_[p].origin;
    pieces_.erase(pieces_.begin() + p);
    pieces_.push_back({rest, origin, {}});
    pieces_.push_back({side, origin, {}});
    was_split_.insert(origin);
    prove_from(pieces_.size() - 2);
    return true;
  }

  // Seams between pieces, the dearest first.
  std::vector<std::pair<double, FacePair>> seams_by_cost() const {
    std::vector<int> piece(mesh_.num_faces());
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (int f : pieces_[p].faces) piece[f] = static_cast<int>(p);
    std::map<FacePair, double> cost;
    for (int f = 0; f < mesh_.num_faces(); ++f)
      for (const DualGraph::Arc& arc : graph_.arcs(f))
        if (piece[f] < piece[arc.to]) cost[{piece[f], piece[arc.to]}] += arc.cost;
    std::vector<std::pair<double, FacePair>> seams;
    for (const auto& [pair, sum] : cost) seams.emplace_back(sum, pair);
    std::stable_sort(seams.begin(), seams.end(), [](const auto& s, const auto& t) { return s.first > t.first; });
    return seams;
  }

  bool holds_a_pair_apart(const std::vector<int>& faces) const {
    return std::any_of(apart_.begin(), apart_.end(), [&](const FacePair& pair) {
      return std::binary_search(faces.begin(), faces.end(), pair.first) &&
             std::binary_search(faces.begin(), faces.end(), pair.second);
    });
  }

  // Joins two pieces when their union is proven. What failed once is not tried again.
  bool join(int p, int q) {
    std::vector<int> faces;
    std::merge(pieces_[p].faces.begin(), pieces_[p].faces.end(), pieces_[q].faces.begin(), pieces_[q].faces.end(),
               std::back_inserter(faces));
    if (failed_.contains(faces) || holds_a_pair_apart(faces) || !may_fit(faces)) return false;
    ProvenPart proof = prove(faces, run_);
    if (!proof.proven() || !fits(proof)) {
      failed_.insert(faces);
      return false;
    }
    pieces_[p] = {std::move(faces), pieces_[p].origin, std::move(proof)};
    pieces_.erase(pieces_.begin() + q);
    return true;
  }

  // Fewest: any neighbours; else only pieces of one part that was split because it failed.
  bool may_join(const Piece& a, const Piece& b) const {
    if (options_.wish == PartsWish::Fewest) return true;
    return a.origin == b.origin && was_split_.contains(a.origin);
  }

  void join_while_proven() {
    bool joined = true;
    while (joined && !run_.over()) {
      joined = false;
      for (const auto& [cost, pair] : seams_by_cost()) {
        if (run_.over() || !may_join(pieces_[pair.first], pieces_[pair.second])) continue;
        run_.report("joining parts", 0, 0);
        joined = join(pair.first, pair.second);
        if (joined) break;
      }
    }
  }

  void note_what_does_not_fit(const Segmentation& parts) {
    const Vec2& room = options_.page->room;
    for (const Piece& piece : pieces_) {
      if (piece.fits) continue;
      const int face = piece.faces[0];
      const std::string what = piece.faces.size() == 1 ? fmt::format("face {}", face)
                                                       : fmt::format("the net of {}", parts.names[parts.part[face]]);
      notes_.push_back(fmt::format("{} does not fit {:.4g} x {:.4g} mm", what, room.x(), room.y()));
    }
  }

  Kit finish() {
    std::vector<int> part(mesh_.num_faces());
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      for (int f : pieces_[p].faces) part[f] = static_cast<int>(p);
    Segmentation parts = segmentation_by_labels(mesh_, part);
    std::vector<ProvenPart> proofs(pieces_.size());
    const bool all_fit = std::all_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.fits; });
    if (!all_fit) note_what_does_not_fit(parts);
    for (Piece& piece : pieces_) proofs[parts.part[piece.faces[0]]] = std::move(piece.proof);
    if (options_.wish == PartsWish::Exactly && parts.num_parts() != options_.parts)
      notes_.push_back(fmt::format("{} parts were asked for, there are {}", options_.parts, parts.num_parts()));
    Kit result = put_together(mesh_, std::move(parts), std::move(proofs), run_);
    if (!all_fit && result.ending == Ending::Found) result.ending = run_.over() ? run_.ending() : Ending::Exhausted;
    if (images_) {
      result.mirror = mirror_partners(result.parts.part, *images_);
      if (const auto lone = std::count(result.mirror.begin(), result.mirror.end(), -1); lone > 0)
        notes_.push_back(fmt::format("{} parts have no mirror image, as some did not fold", lone));
    }
    result.notes = std::move(notes_);
    return result;
  }

  const Mesh& mesh_;
  const SegmentOptions& options_;
  const Run& run_;
  DualGraph graph_;
  std::optional<Foldability> foldability_;  // for clusters
  std::uint64_t cuts_made_ = 0;             // by clusters or at random: each has a random stream of its own
  std::vector<FacePair> apart_;             // certainly not in one part
  std::optional<std::vector<int>> images_;  // mirrored, of every face
  std::vector<Piece> pieces_;
  std::set<std::vector<int>> failed_;  // sets of faces that have no proof: the ledger
  std::set<int> was_split_;            // origins
  std::vector<std::string> notes_;
};

}  // namespace

void check(const SegmentOptions& options) {
  require(options.neck > 0, "neck", options.neck, "above 0");
  require(options.max_parts >= 1, "max-parts", options.max_parts, "at least 1");
  if (options.page) {
    require(options.page->scale > 0, "scale", options.page->scale, "above 0 mm per unit");
    require(options.page->room.minCoeff() > 0, "page", options.page->room.minCoeff(), "wider than margins and tabs");
  }
  require(options.min_area >= 0 && options.min_area <= 0.5, "min-area", options.min_area, "in [0, 0.5]");
}

void set_wish(SegmentOptions& options, const std::string& word) {
  options.wish = word == "auto" ? PartsWish::Auto : word == "fewest" ? PartsWish::Fewest : PartsWish::Exactly;
  if (options.wish != PartsWish::Exactly) return;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), options.parts);
  if (error != std::errc() || end != word.data() + word.size() || options.parts < 1)
    throw InvalidOption(fmt::format("parts = {} must be auto, fewest or a number of at least 1", word));
}

Kit segment_mesh(const Mesh& mesh, const SegmentOptions& options, const Run& run) {
  check(options);
  if (options.wish == PartsWish::Exactly) {
    const int least = components(mesh).count;
    require(options.parts >= least && options.parts <= mesh.num_faces(), "parts", options.parts,
            fmt::format("in [{}, {}], the components and the faces of the mesh", least, mesh.num_faces()));
  }
  check(options.faces, mesh.num_faces());
  if (options.faces.any() && options.method != SegmentMethod::Necks)
    throw InvalidOption("faces are kept together or apart by --method necks only");
  if (options.symmetric != Symmetry::Off && (options.faces.any() || options.method != SegmentMethod::Necks))
    throw InvalidOption("parts are symmetric by --method necks only, without --keep and --apart");
  if (options.method == SegmentMethod::Clusters)
    require(mesh.num_faces() <= kMostForClusters, "faces", mesh.num_faces(),
            fmt::format("at most {} for clusters, whose matrix is dense", kMostForClusters));
  return Segmenter(mesh, options, run).run();
}

}  // namespace plico
