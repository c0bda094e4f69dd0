#include "plico/origami/discrete_states.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_set>

#include "plico/base/error.h"
#include "plico/base/rng.h"
#include "plico/origami/closure.h"

namespace plico {
namespace {

void check(const DiscreteOptions& o) { require(o.tolerance > 0, "tolerance", o.tolerance, "above 0"); }

// The choices to make: one a group of creases.
class Domain {
 public:
  Domain(const Linkage& linkage, const DiscreteOptions& options) : options_(options) {
    check(options);
    for (const Hinge& hinge : linkage.hinges)
      angles_.push_back(important_angles(hinge.target, options.angles, hinge.high));
    group_ = options.groups;
    if (group_.empty())
      for (int h = 0; h < num_hinges(); ++h) group_.push_back(h);
    gather();
    for (const RealVertex& vertex : linkage.loops) loops_.push_back({vertex});
    find_groups_around();
  }

  int num_hinges() const { return static_cast<int>(angles_.size()); }
  int num_groups() const { return static_cast<int>(creases_.size()); }
  int num_loops() const { return static_cast<int>(loops_.size()); }
  int choices(int group) const { return static_cast<int>(angles_[creases_[group].front()].size()); }
  const std::vector<int>& groups_around(int loop) const { return around_[loop]; }

  void choose(int group, int choice, Configuration& config) const {
    for (int h : creases_[group]) config[h] = angles_[h][choice];
  }
  bool closes(int loop, const Configuration& config) const {
    return closure(loops_[loop], config).worst <= options_.tolerance;
  }

 private:
  void find_groups_around() {
    for (const std::vector<RealVertex>& loop : loops_) {
      std::vector<int>& groups = around_.emplace_back();
      for (int h : loop.front().hinges) groups.push_back(group_[h]);
      std::sort(groups.begin(), groups.end());
      groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    }
  }

  void gather() {
    if (static_cast<int>(group_.size()) != num_hinges())
      throw InvalidInput("origami/groups", fmt::format("{} groups given for {} creases", group_.size(), num_hinges()));
    for (int h = 0; h < num_hinges(); ++h) {
      if (group_[h] < 0 || group_[h] >= num_hinges())
        throw InvalidInput("origami/groups", "a group has no such number", fmt::format("crease {}", h));
      if (group_[h] >= num_groups()) creases_.resize(group_[h] + 1);
      creases_[group_[h]].push_back(h);
      const auto &first = angles_[creases_[group_[h]].front()], &own = angles_[h];
      const auto same_size = [](double a, double b) { return std::abs(std::abs(a) - std::abs(b)) < 1e-12; };
      if (!std::equal(own.begin(), own.end(), first.begin(), first.end(), same_size))
        throw InvalidInput("origami/groups", "creases of one group have targets of different size",
                           fmt::format("creases {} and {}", creases_[group_[h]].front(), h));
    }
    for (int g = 0; g < num_groups(); ++g)
      if (creases_[g].empty()) throw InvalidInput("origami/groups", fmt::format("group {} has no crease", g));
  }

  const DiscreteOptions& options_;
  std::vector<std::vector<double>> angles_;     // of each hinge
  std::vector<int> group_;                      // of each hinge
  std::vector<std::vector<int>> creases_;       // of each group
  std::vector<std::vector<RealVertex>> loops_;  // one each, as closure() takes them
  std::vector<std::vector<int>> around_;        // groups of each loop
};

// Groups in the order of choice, each with the loops that it completes. The next loop is one with the fewest groups
// still open, so that dead ends show early.
struct Schedule {
  std::vector<int> groups;
  std::vector<std::vector<int>> completes;
};

Schedule schedule(const Domain& domain) {
  Schedule result;
  std::vector<char> chosen(domain.num_groups(), 0), done(domain.num_loops(), 0);
  const auto open = [&](int loop) {
    return std::count_if(domain.groups_around(loop).begin(), domain.groups_around(loop).end(),
                         [&](int g) { return !chosen[g]; });
  };
  const auto add = [&](int g) {
    chosen[g] = 1;
    result.groups.push_back(g);
    std::vector<int>& completes = result.completes.emplace_back();
    for (int loop = 0; loop < domain.num_loops(); ++loop)
      if (!done[loop] && open(loop) == 0) {
        done[loop] = 1;
        completes.push_back(loop);
      }
  };
  for (;;) {
    int next = -1;
    for (int loop = 0; loop < domain.num_loops(); ++loop)
      if (!done[loop] && (next < 0 || open(loop) < open(next))) next = loop;
    if (next < 0) break;
    for (int g : domain.groups_around(next))
      if (!chosen[g]) add(g);
  }
  for (int g = 0; g < domain.num_groups(); ++g)
    if (!chosen[g]) add(g);
  return result;
}

class Enumeration {
 public:
  Enumeration(const Domain& domain, long most, const Run& run)
      : domain_(domain), schedule_(schedule(domain)), most_(most), run_(run) {}

  DiscreteStates all() {
    config_ = Configuration::Zero(domain_.num_hinges());
    descend(0);
    return std::move(result_);
  }

 private:
  bool full() const { return static_cast<long>(result_.states.size()) >= most_ || result_.tested >= kMostTested; }

  void descend(std::size_t level) {
    if (level == schedule_.groups.size()) {
      result_.states.push_back(config_);
      return;
    }
    const int group = schedule_.groups[level];
    for (int choice = 0; choice < domain_.choices(group); ++choice) {
      if (run_.over()) result_.ending = run_.ending();
      if (full()) result_.ending = Ending::Exhausted;
      if (result_.ending != Ending::Found) return;
      domain_.choose(group, choice, config_);
      const auto& loops = schedule_.completes[level];
      result_.tested += static_cast<long>(loops.size());
      if (std::all_of(loops.begin(), loops.end(), [&](int loop) { return domain_.closes(loop, config_); }))
        descend(level + 1);
    }
    domain_.choose(group, 0, config_);
  }

  const Domain& domain_;
  Schedule schedule_;
  long most_;
  const Run& run_;
  Configuration config_;
  DiscreteStates result_;
};

}  // namespace

std::vector<double> important_angles(double target, AngleSet set, double limit) {
  std::vector<double> angles = {0};
  if (target == 0) return angles;
  const auto add = [&](double size) {
    const double angle = std::copysign(std::min(size, limit), target);
    if (std::none_of(angles.begin(), angles.end(), [&](double a) { return std::abs(a - angle) < 1e-12; }))
      angles.push_back(angle);
  };
  if (set == AngleSet::Discrete4) add(kPi / 2);
  add(kPi);
  add(std::abs(target));
  return angles;
}

DiscreteStates discrete_states(const Linkage& linkage, const DiscreteOptions& options, long most, const Run& run) {
  const Domain domain(linkage, options);
  return Enumeration(domain, most, run).all();
}

DiscreteStates sample_discrete_states(const Linkage& linkage, const DiscreteOptions& options, long samples,
                                      std::uint64_t seed, const Run& run) {
  const Domain domain(linkage, options);
  DiscreteStates result;
  std::unordered_set<std::string> seen;
  Rng rng(seed);
  Configuration config = Configuration::Zero(domain.num_hinges());
  std::string key(domain.num_groups(), '\0');
  for (long i = 0; i < samples; ++i) {
    if (i % 1024 == 0 && run.over()) {
      result.ending = run.ending();
      break;
    }
    for (int g = 0; g < domain.num_groups(); ++g) {
      const int choice = i == 0 ? 0 : rng.below(domain.choices(g));  // flat is the first
      key[g] = static_cast<char>(choice);
      domain.choose(g, choice, config);
    }
    if (!seen.insert(key).second) continue;
    bool valid = true;
    for (int loop = 0; loop < domain.num_loops() && valid; ++loop) {
      ++result.tested;
      valid = domain.closes(loop, config);
    }
    if (valid) result.states.push_back(config);
  }
  return result;
}

std::vector<int> groups_of(const std::vector<Configuration>& states) {
  std::vector<int> groups;
  std::map<std::vector<long>, int> known;
  const int hinges = states.empty() ? 0 : static_cast<int>(states.front().size());
  for (int h = 0; h < hinges; ++h) {
    std::vector<long> sizes;
    for (const Configuration& state : states) sizes.push_back(std::lround(1e9 * std::abs(state[h])));
    groups.push_back(known.try_emplace(std::move(sizes), static_cast<int>(known.size())).first->second);
  }
  return groups;
}

}  // namespace plico
