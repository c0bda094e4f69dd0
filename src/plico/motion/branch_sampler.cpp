#include "plico/motion/branch_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "plico/base/error.h"
#include "plico/base/libm.h"
#include "plico/motion/penetration.h"
#include "plico/motion/plates.h"

namespace plico {
namespace {

Pose turn_about_x(double angle) {
  const double c = plico::cos(angle), s = plico::sin(angle);
  Pose turn = Pose::Identity();
  turn.linear() << 1, 0, 0, 0, c, -s, 0, s, c;
  return turn;
}

constexpr int kBlock = 16;                  // boxes of plates under one box
constexpr std::size_t kMostOver = 100'000;  // poses over sides that are kept, of all samples: some megabytes

}  // namespace

// Box of some corners, rounded outward.
struct BranchSampler::FloatBox {
  float low[3], high[3];
  FloatBox(const Vec3* corners, int count) {
    for (int k = 0; k < 3; ++k) {
      double least = corners[0][k], most = least;
      for (int i = 1; i < count; ++i) {
        least = std::min(least, corners[i][k]);
        most = std::max(most, corners[i][k]);
      }
      low[k] = static_cast<float>(least) - slack(least);
      high[k] = static_cast<float>(most) + slack(most);
    }
  }
  // Does it meet box i? As numbers: six tests without a branch.
  bool meets(const Boxes& boxes, int i) const {
    return (int{boxes[0][i] <= high[0]} & int{low[0] <= boxes[3][i]} & int{boxes[1][i] <= high[1]} &
            int{low[1] <= boxes[4][i]} & int{boxes[2][i] <= high[2]} & int{low[2] <= boxes[5][i]}) != 0;
  }

 private:
  // More than what rounding to a float, and this sum, lose.
  static float slack(double x) {
    return 2 * std::numeric_limits<float>::epsilon() * static_cast<float>(std::abs(x)) +
           std::numeric_limits<float>::min();
  }
};

BranchSampler::BranchSampler(const PanelKit& kit, FoldingLaw law, double clearance, double touch)
    : kit_(kit), law_(law), touch_(touch), mark_(kit.outlines.size(), 0) {
  make_plates(clearance);
  for (double angle : kit.fold_angle) steepest_ = std::max(steepest_, std::abs(angle));
  for (int p = 0; p < kit.num_panels(); ++p) {
    const std::vector<Vec2>& outline = kit.outlines[p];
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 from = outline[i], along = (outline[(i + 1) % outline.size()] - from).normalized();
      Pose frame = Pose::Identity();
      frame.linear() << along.x(), -along.y(), 0, along.y(), along.x(), 0, 0, 0, 1;
      frame.translation() << from, 0;
      side_frame_.push_back(frame);
      side_panel_.push_back(p);
    }
  }
  find_beyond();
}

// The twin runs the other way, so its frame is turned by half a turn and begins at the other end.
void BranchSampler::find_beyond() {
  for (std::size_t side = 0; side < side_panel_.size(); ++side) {
    beyond_.push_back(Pose::Identity());
    if (kit_.twin[side] < 0) continue;
    const std::vector<Vec2>& outline = kit_.outlines[side_panel_[side]];
    const std::size_t i = side - kit_.first_side[side_panel_[side]];
    Pose turned = Pose::Identity();
    turned.linear().diagonal() << -1, -1, 1;
    turned.translation() << (outline[(i + 1) % outline.size()] - outline[i]).norm(), 0, 0;
    beyond_[side] = turned * side_frame_[kit_.twin[side]].inverse();
  }
}

Linkage loose_panels(const PanelKit& kit) {
  Linkage linkage;
  for (const std::vector<Vec2>& outline : kit.outlines) {
    std::vector<Vec3>& panel = linkage.panels.emplace_back();
    for (const Vec2& corner : outline) panel.emplace_back(corner.x(), corner.y(), 0);
  }
  return linkage;
}

void BranchSampler::make_plates(double clearance) {
  const Plates plates = plico::make_plates(loose_panels(kit_), clearance);
  shape_ = plates.corners;
  first_plate_ = plates.first_of_panel;
  for (int i = 0; i < plates.size(); ++i)
    plates_.push_back({plates.panel[i], plates.first[i], plates.first[i + 1] - plates.first[i]});
}

double BranchSampler::angle_at(int side, double time) const {
  const double target = kit_.fold_angle[side];
  if (law_ == FoldingLaw::Linear) return time * target;
  return std::clamp(target, -time * steepest_, time * steepest_);
}

// The panel over a side lies right of it; raising it to the front (a valley) is a left-handed turn about the side.
Pose BranchSampler::across(int side, double time) const {
  return side_frame_[side] * turn_about_x(-angle_at(side, time)) * beyond_[side];
}

BranchSampler::Rigid BranchSampler::pose_over(const Sample& sample, int side) const {
  if (!sample.over.empty()) return sample.over[side];
  const Pose pose = across(side, sample.time);
  return {pose.linear(), pose.translation()};
}

void BranchSampler::find_over(Sample& sample) const {
  std::size_t kept = 0;
  for (const Sample& other : samples_) kept += other.over.size();
  if (kept + side_panel_.size() > kMostOver) return;
  std::vector<Rigid> over;
  for (int side = 0; side < static_cast<int>(side_panel_.size()); ++side)
    over.push_back(kit_.twin[side] < 0 ? Rigid{} : pose_over(sample, side));
  sample.over = std::move(over);
}

void BranchSampler::place_plate(Sample& sample, int plate) const {
  const auto& [panel, first, count] = plates_[plate];
  const Rigid& pose = sample.pose[panel];
  for (int c = first; c < first + count; ++c) sample.corners[c] = pose * shape_[c];
  const FloatBox box(&sample.corners[first], count);
  const int place = place_[plate];
  for (int k = 0; k < 3; ++k) sample.boxes[k][place] = box.low[k], sample.boxes[k + 3][place] = box.high[k];
}

// Numbers the plates along the tree, branch by branch: neighbours there stay close at every moment.
void BranchSampler::line_up() {
  hung_since_lining_up_ = 0;
  plate_at_.clear();
  queue_.assign(1, {0, -1});
  while (!queue_.empty()) {
    const auto [p, entered_by] = queue_.back();
    queue_.pop_back();
    for (int i = first_plate_[p]; i < first_plate_[p + 1]; ++i) plate_at_.push_back(i);
    for (int side = kit_.first_side[p]; side < kit_.first_side[p + 1]; ++side)
      if (is_joined_[side] && side != entered_by) queue_.emplace_back(side_panel_[kit_.twin[side]], kit_.twin[side]);
  }
  place_.resize(plates_.size());
  for (std::size_t i = 0; i < plate_at_.size(); ++i) place_[plate_at_[i]] = static_cast<int>(i);
}

void BranchSampler::bound_block(Sample& sample, int block) const {
  const int first = block * kBlock, end = std::min(first + kBlock, static_cast<int>(plates_.size()));
  for (int k = 0; k < 3; ++k) {
    const auto low = sample.boxes[k].begin(), high = sample.boxes[k + 3].begin();
    sample.blocks[k][block] = *std::min_element(low + first, low + end);
    sample.blocks[k + 3][block] = *std::max_element(high + first, high + end);
  }
}

// Places all panels that hang on `root`, whose pose is known, without crossing its side `barred` (-1: none).
void BranchSampler::place_from(Sample& sample, int root, int barred) {
  queue_.assign(1, {root, barred});
  for (std::size_t at = 0; at < queue_.size(); ++at) {
    const auto [p, entered_by] = queue_[at];
    for (int i = first_plate_[p]; i < first_plate_[p + 1]; ++i) place_plate(sample, i);
    for (int side = kit_.first_side[p]; side < kit_.first_side[p + 1]; ++side) {
      if (!is_joined_[side] || side == entered_by) continue;
      const int q = side_panel_[kit_.twin[side]];
      sample.pose[q] = sample.pose[p] * pose_over(sample, side);
      queue_.emplace_back(q, kit_.twin[side]);
    }
  }
  work_ += static_cast<long>(queue_.size());
}

void BranchSampler::place_all(Sample& sample) {
  sample.pose.assign(kit_.num_panels(), Rigid{});
  sample.corners.resize(shape_.size());
  const std::size_t num_blocks = (plates_.size() + kBlock - 1) / kBlock;
  for (auto& bound : sample.boxes) bound.resize(plates_.size());
  for (auto& bound : sample.blocks) bound.resize(num_blocks);
  place_from(sample, 0, -1);
  PLICO_ASSERT(static_cast<int>(queue_.size()) == kit_.num_panels());
  for (std::size_t block = 0; block < num_blocks; ++block) bound_block(sample, static_cast<int>(block));
}

void BranchSampler::reset(const std::vector<char>& is_joined) {
  is_joined_ = is_joined;
  for (std::size_t side = 0; side < is_joined.size(); ++side)
    if (is_joined[side]) is_joined_[kit_.twin[side]] = 1;
  conflicts_.clear();
  foreseen_.side = -1;
  line_up();
  for (int k = 0; k < num_samples(); ++k) {
    place_all(samples_[k]);
    find_conflicts(k);
  }
}

void BranchSampler::add_sample(double time) {
  foreseen_.side = -1;
  samples_.push_back({time, {}, {}, {}, {}, {}});
  find_over(samples_.back());
  sample_order_.insert(sample_order_.begin(), num_samples() - 1);
  if (is_joined_.empty()) return;
  place_all(samples_.back());
  find_conflicts(num_samples() - 1);
}

void BranchSampler::keep_samples(int most) {
  PLICO_ASSERT(conflicts_.empty());
  if (num_samples() <= most) return;
  foreseen_.side = -1;
  std::vector<Sample> kept;
  for (int i = 0; i < most; ++i) kept.push_back(std::move(samples_[sample_order_[i]]));
  samples_ = std::move(kept);
  sample_order_.resize(most);
  std::iota(sample_order_.begin(), sample_order_.end(), 0);
}

bool BranchSampler::penetrating(const Sample& sample, int plate, const Vec3* corners, const Vec3& normal,
                                int other) const {
  const Plate& a = plates_[plate];
  const Plate& b = plates_[other];
  return penetrate({corners, a.count, normal}, {&sample.corners[b.first], b.count, sample.pose[b.panel].turn.col(2)},
                   touch_);
}

void BranchSampler::find_conflicts(int k) {
  const Sample& sample = samples_[k];
  const auto joined = [&](int a, int b) {
    for (int side = kit_.first_side[a]; side < kit_.first_side[a + 1]; ++side)
      if (is_joined_[side] && side_panel_[kit_.twin[side]] == b) return true;
    return false;
  };
  std::vector<int> order(plates_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const Boxes& bound = sample.boxes;
  std::sort(order.begin(), order.end(), [&](int a, int b) { return bound[0][a] < bound[0][b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int a = order[i], plate_a = plate_at_[a];
    for (std::size_t j = i + 1; j < order.size() && bound[0][order[j]] <= bound[3][a]; ++j) {
      const int b = order[j], plate_b = plate_at_[b], panel_a = plates_[plate_a].panel,
                panel_b = plates_[plate_b].panel;
      if (bound[1][b] > bound[4][a] || bound[1][a] > bound[4][b] || bound[2][b] > bound[5][a] ||
          bound[2][a] > bound[5][b] || panel_a == panel_b || joined(panel_a, panel_b))
        continue;
      const Vec3 normal = sample.pose[panel_a].turn.col(2);
      if (penetrating(sample, plate_a, &sample.corners[plates_[plate_a].first], normal, plate_b))
        conflicts_.push_back({k, panel_a, panel_b});
    }
  }
}

void BranchSampler::mark(std::span<const int> branch) {
  ++stamp_;
  for (int panel : branch) mark_[panel] = stamp_;
}

long BranchSampler::conflicts_across(std::span<const int> branch) {
  mark(branch);
  return std::count_if(conflicts_.begin(), conflicts_.end(),
                       [&](const Conflict& c) { return (mark_[c.panel_a] == stamp_) != (mark_[c.panel_b] == stamp_); });
}

// What a branch goes through when it is hung by `side`.
BranchSampler::Rigid BranchSampler::moved_by(const Sample& sample, int side) const {
  const int twin = kit_.twin[side];
  return sample.pose[side_panel_[twin]] * pose_over(sample, twin) * sample.pose[side_panel_[side]].inverse();
}

void BranchSampler::move_branch(const Sample& sample, std::span<const int> branch, const Rigid& motion) {
  moved_.clear();
  for (int panel : branch) {
    const int first = plates_[first_plate_[panel]].first, last = first_plate_[panel + 1] - 1;
    for (int c = first; c < plates_[last].first + plates_[last].count; ++c)
      moved_.push_back(motion * sample.corners[c]);
  }
}

void BranchSampler::find_near(const Sample& sample) {
  const FloatBox all(moved_.data(), static_cast<int>(moved_.size()));
  near_.clear();
  near_blocks_.clear();
  for (int block = 0; block < static_cast<int>(sample.blocks[0].size()); ++block) {
    if (!all.meets(sample.blocks, block)) continue;
    const int end = std::min((block + 1) * kBlock, static_cast<int>(plates_.size()));
    for (int i = block * kBlock; i < end; ++i)
      if (all.meets(sample.boxes, i) && mark_[plates_[plate_at_[i]].panel] != stamp_) near_.push_back(i);
    if (near_blocks_.empty() ? !near_.empty() : near_blocks_.back().second < static_cast<int>(near_.size()))
      near_blocks_.emplace_back(block, static_cast<int>(near_.size()));
  }
}

// Calls visit(plate) for the near ones whose boxes meet `box` until it returns true.
template <class Visit>
bool BranchSampler::visit_near(const Sample& sample, const FloatBox& box, Visit visit) const {
  int next = 0;
  for (const auto& [block, end] : near_blocks_) {
    const int first = std::exchange(next, end);
    if (!box.meets(sample.blocks, block)) continue;
    for (int i = first; i < end; ++i)
      if (box.meets(sample.boxes, near_[i]) && visit(plate_at_[near_[i]])) return true;
  }
  return false;
}

// Calls found(panel of the branch, panel of the rest) for colliding pairs until it returns true. The branch is marked.
template <class Found>
bool BranchSampler::meet(const Sample& sample, std::span<const int> branch, int side, Found found) {
  const Rigid motion = moved_by(sample, side);
  const int hinge_in = side_panel_[side], hinge_out = side_panel_[kit_.twin[side]];
  move_branch(sample, branch, motion);
  work_ += static_cast<long>(moved_.size());
  find_near(sample);
  if (near_.empty()) return false;
  const Vec3* corners = moved_.data();
  for (int panel : branch) {
    const Vec3 normal = motion.turn * sample.pose[panel].turn.col(2);
    for (int i = first_plate_[panel]; i < first_plate_[panel + 1]; corners += plates_[i].count, ++i) {
      const bool enough = visit_near(sample, FloatBox(corners, plates_[i].count), [&](int other) {
        const int other_panel = plates_[other].panel;
        if (panel == hinge_in && other_panel == hinge_out) return false;
        return penetrating(sample, i, corners, normal, other) && found(panel, other_panel);
      });
      if (enough) return true;
    }
  }
  return false;
}

long BranchSampler::conflicts_if_hung(std::span<const int> branch, int side, long limit) {
  mark(branch);
  foreseen_.side = -1;
  foreseen_.conflicts.clear();
  for (std::size_t at = 0; at < sample_order_.size(); ++at) {
    const int k = sample_order_[at];
    const bool too_many = meet(samples_[k], branch, side, [&](int a, int b) {
      foreseen_.conflicts.push_back({k, a, b});
      return static_cast<long>(foreseen_.conflicts.size()) > limit;
    });
    if (!too_many) continue;
    if (at > 0) std::swap(sample_order_[at], sample_order_[at / 2]);
    return static_cast<long>(foreseen_.conflicts.size());
  }
  foreseen_.side = side;
  foreseen_.branch.assign(branch.begin(), branch.end());
  return static_cast<long>(foreseen_.conflicts.size());
}

void BranchSampler::unjoin(std::span<const int> branch) {
  for (int panel : branch) {
    for (int s = kit_.first_side[panel]; s < kit_.first_side[panel + 1]; ++s)
      if (is_joined_[s] && mark_[side_panel_[kit_.twin[s]]] != stamp_) is_joined_[s] = is_joined_[kit_.twin[s]] = 0;
  }
}

// Panel by panel along the tree, not by the branch's motion: that would double rounding errors at every hanging.
void BranchSampler::place_branch(Sample& sample, int side) {
  const int twin = kit_.twin[side], panel = side_panel_[side];
  sample.pose[panel] = sample.pose[side_panel_[twin]] * pose_over(sample, twin);
  place_from(sample, panel, side);
  for (int block : touched_) bound_block(sample, block);
}

void BranchSampler::find_blocks(std::span<const int> branch) {
  touched_.clear();
  for (int panel : branch)
    for (int i = first_plate_[panel]; i < first_plate_[panel + 1]; ++i) touched_.push_back(place_[i] / kBlock);
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
}

void BranchSampler::hang(std::span<const int> branch, int side) {
  if (foreseen_.side != side || !std::ranges::equal(foreseen_.branch, branch))
    conflicts_if_hung(branch, side, std::numeric_limits<long>::max());
  mark(branch);
  const auto inside = [&](int panel) { return mark_[panel] == stamp_; };
  std::erase_if(conflicts_, [&](const Conflict& c) { return inside(c.panel_a) != inside(c.panel_b); });
  conflicts_.insert(conflicts_.end(), foreseen_.conflicts.begin(), foreseen_.conflicts.end());
  foreseen_.side = -1;
  unjoin(branch);
  is_joined_[side] = is_joined_[kit_.twin[side]] = 1;
  find_blocks(branch);
  for (Sample& sample : samples_) place_branch(sample, side);
  if (++hung_since_lining_up_ < kit_.num_panels()) return;
  line_up();
  for (Sample& sample : samples_) place_all(sample);
}

}  // namespace plico
