// Instead of CaDiCaL, which a page has no room for: a solver of the same kind, small. Conflict-driven clause learning
// with two watched literals, activities that decay, kept phases and Luby's restarts. Source: N. Eén and N. Sörensson,
// An extensible SAT-solver, 2003. The same clauses in the same order give the same answer.
#include "plico/base/sat.h"

#include <algorithm>
#include <cstdlib>
#include <queue>
#include <utility>

namespace plico {
namespace {

constexpr int kUnset = -1, kNoReason = -1, kNoClause = -1;
constexpr double kDecay = 0.95, kLargest = 1e100;
constexpr int kRestart = 100;           // conflicts, times what luby() says
constexpr int kConflictsPerLook = 256;  // at the clock
constexpr std::size_t kLearntAtFirst = 4000;

// 1 1 2 1 1 2 4 ...
int luby(int i) {
  int size = 1, power = 0;
  while (size < i + 1) size = 2 * size + 1, ++power;
  while (size - 1 != i) {
    size = (size - 1) / 2;
    --power;
    i %= size;
  }
  return 1 << power;
}

}  // namespace

// Literals are 2 v and 2 v + 1 for variable v and its negation.
struct SatSolver::Solver {
  struct Clause {
    std::vector<int> literals;
    bool learnt = false;
  };
  std::vector<Clause> clauses;
  std::vector<std::vector<int>> watches;  // of each literal: clauses that look whether it becomes false
  std::vector<int> value;                 // of each literal: 1, 0 or kUnset
  std::vector<int> level, reason;         // of each variable
  std::vector<char> phase, seen;
  std::vector<double> activity;
  std::vector<int> trail, begins;  // begins: where each level begins on the trail
  std::size_t head = 0, learnt = 0, most_learnt = kLearntAtFirst;
  double bump = 1;
  std::priority_queue<std::pair<double, int>> order;  // the most active first; old entries are passed over
  std::vector<int> assumed, at_fault, model;
  bool contradicts = false;

  static int literal(int signed_variable) { return 2 * (std::abs(signed_variable) - 1) + (signed_variable < 0); }
  int depth() const { return static_cast<int>(begins.size()); }

  void reserve(int lit) {
    while (static_cast<int>(value.size()) <= (lit | 1)) {
      const int v = static_cast<int>(level.size());
      value.insert(value.end(), 2, kUnset);
      watches.resize(watches.size() + 2);
      level.push_back(0);
      reason.push_back(kNoReason);
      phase.push_back(1);
      seen.push_back(0);
      activity.push_back(0);
      order.push({0, -v});
    }
  }

  void set(int lit, int why) {
    value[lit] = 1;
    value[lit ^ 1] = 0;
    level[lit / 2] = depth();
    reason[lit / 2] = why;
    trail.push_back(lit);
  }

  void back_to(int depth_wanted) {
    if (depth() <= depth_wanted) return;
    for (std::size_t i = begins[depth_wanted]; i < trail.size(); ++i) {
      const int v = trail[i] / 2;
      phase[v] = static_cast<char>(trail[i] & 1);
      value[trail[i]] = value[trail[i] ^ 1] = kUnset;
      order.push({activity[v], -v});
    }
    trail.resize(begins[depth_wanted]);
    begins.resize(depth_wanted);
    head = trail.size();
  }

  void attach(int clause) {
    for (int i : {0, 1}) watches[clauses[clause].literals[i]].push_back(clause);
  }

  void add(const std::vector<int>& given) {
    back_to(0);
    std::vector<int> literals;
    for (int one : given) literals.push_back(literal(one));
    std::sort(literals.begin(), literals.end());
    literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
    for (int lit : literals) reserve(lit);
    for (std::size_t i = 0; i + 1 < literals.size(); ++i)
      if ((literals[i] ^ 1) == literals[i + 1]) return;  // always holds
    if (std::any_of(literals.begin(), literals.end(), [&](int lit) { return value[lit] == 1; })) return;
    std::erase_if(literals, [&](int lit) { return value[lit] == 0; });
    if (literals.empty()) {
      contradicts = true;
    } else if (literals.size() == 1) {
      set(literals.front(), kNoReason);
    } else {
      clauses.push_back({literals, false});
      attach(static_cast<int>(clauses.size()) - 1);
    }
  }

  // The clause that became false, or kNoClause.
  int propagate() {
    while (head < trail.size()) {
      const int gone = trail[head++] ^ 1;
      std::vector<int>& watching = watches[gone];
      std::size_t kept = 0;
      for (std::size_t i = 0; i < watching.size(); ++i) {
        const int clause = watching[i];
        std::vector<int>& literals = clauses[clause].literals;
        if (literals[0] == gone) std::swap(literals[0], literals[1]);
        const auto other = value[literals[0]] == 1 ? literals.end()
                                                   : std::find_if(literals.begin() + 2, literals.end(),
                                                                  [&](int lit) { return value[lit] != 0; });
        if (value[literals[0]] != 1 && other != literals.end()) {
          std::swap(literals[1], *other);
          watches[literals[1]].push_back(clause);
          continue;
        }
        watching[kept++] = clause;
        if (value[literals[0]] == 1) continue;
        if (value[literals[0]] == kUnset) {
          set(literals[0], clause);
          continue;
        }
        while (++i < watching.size()) watching[kept++] = watching[i];
        watching.resize(kept);
        return clause;
      }
      watching.resize(kept);
    }
    return kNoClause;
  }

  void make_active(int v) {
    if ((activity[v] += bump) > kLargest) {
      for (double& a : activity) a /= kLargest;
      bump /= kLargest;
      order = {};
      for (int u = 0; u < static_cast<int>(activity.size()); ++u) order.push({activity[u], -u});
    }
    if (value[2 * v] == kUnset) order.push({activity[v], -v});
  }

  // From a conflict to what it teaches: the first literal is the one that will hold, at the level that is told.
  std::pair<std::vector<int>, int> learn(int conflict) {
    std::vector<int> learned{0};
    int open = 0, last = -1, back = 0;
    std::size_t at = trail.size();
    for (int clause = conflict;; clause = reason[last / 2]) {
      for (int lit : clauses[clause].literals) {
        const int v = lit / 2;
        if (lit == last || seen[v] || level[v] == 0) continue;
        seen[v] = 1;
        make_active(v);
        if (level[v] == depth()) {
          ++open;
        } else {
          learned.push_back(lit);
          back = std::max(back, level[v]);
        }
      }
      do last = trail[--at];
      while (!seen[last / 2]);
      seen[last / 2] = 0;
      if (--open == 0) break;
    }
    learned[0] = last ^ 1;
    for (int lit : learned) seen[lit / 2] = 0;
    const auto second =
        std::find_if(learned.begin() + 1, learned.end(), [&](int lit) { return level[lit / 2] == back; });
    if (second != learned.end()) std::swap(learned[1], *second);
    return {learned, back};
  }

  void take(const std::vector<int>& learned) {
    if (learned.size() == 1) return set(learned.front(), kNoReason);
    clauses.push_back({learned, true});
    ++learnt;
    attach(static_cast<int>(clauses.size()) - 1);
    set(learned.front(), static_cast<int>(clauses.size()) - 1);
  }

  // Half of what was learnt, the long ones first; at depth 0, where no reason is asked for any more.
  void forget() {
    std::vector<std::size_t> sizes;
    for (const Clause& clause : clauses)
      if (clause.learnt) sizes.push_back(clause.literals.size());
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<long>(sizes.size() / 2), sizes.end());
    const std::size_t longest = std::max<std::size_t>(2, sizes[sizes.size() / 2]);
    std::erase_if(clauses, [&](const Clause& clause) { return clause.learnt && clause.literals.size() > longest; });
    for (std::vector<int>& watching : watches) watching.clear();
    for (std::size_t i = 0; i < clauses.size(); ++i) attach(static_cast<int>(i));
    for (int& why : reason) why = kNoReason;
    learnt = std::count_if(clauses.begin(), clauses.end(), [](const Clause& clause) { return clause.learnt; });
    most_learnt += most_learnt / 10 + learnt / 2;
  }

  // Assumptions because of which this one cannot hold.
  void blame(int lit) {
    at_fault = {lit};
    if (depth() == 0 || level[lit / 2] == 0) return;
    seen[lit / 2] = 1;
    for (std::size_t i = trail.size(); i-- > static_cast<std::size_t>(begins[0]);) {
      const int v = trail[i] / 2;
      if (!seen[v]) continue;
      seen[v] = 0;
      if (reason[v] == kNoReason) {  // so far nothing but assumptions was decided
        at_fault.push_back(trail[i]);
        continue;
      }
      for (int other : clauses[reason[v]].literals)
        if (other / 2 != v && level[other / 2] > 0) seen[other / 2] = 1;
    }
  }

  // The next literal to try: assumptions first. False: all are set, or an assumption cannot hold.
  enum class Next { Set, All, Clash };
  Next decide() {
    while (depth() < static_cast<int>(assumed.size())) {
      const int lit = assumed[depth()];
      if (value[lit] == 0) {
        blame(lit);
        return Next::Clash;
      }
      begins.push_back(static_cast<int>(trail.size()));
      if (value[lit] == 1) continue;
      set(lit, kNoReason);
      return Next::Set;
    }
    while (!order.empty()) {
      const int v = -order.top().second;
      order.pop();
      if (value[2 * v] != kUnset) continue;
      begins.push_back(static_cast<int>(trail.size()));
      set(2 * v + phase[v], kNoReason);
      return Next::Set;
    }
    return Next::All;
  }

  SatAnswer search(const Run& run) {
    int conflicts = 0, restarts = 0, until_restart = kRestart;
    for (;;) {
      const int conflict = propagate();
      if (conflict == kNoClause) {
        const Next next = decide();
        if (next == Next::Set) continue;
        if (next == Next::All) model = value;
        return next == Next::All ? SatAnswer::Satisfiable : SatAnswer::Unsatisfiable;
      }
      if (depth() == 0) {
        contradicts = true;
        return SatAnswer::Unsatisfiable;
      }
      if (++conflicts % kConflictsPerLook == 0 && run.over()) return SatAnswer::RunOver;
      const auto [learned, back] = learn(conflict);
      back_to(back);
      take(learned);
      bump /= kDecay;
      if (--until_restart > 0) continue;
      until_restart = kRestart * luby(++restarts);
      back_to(0);
      if (learnt > most_learnt) forget();
    }
  }

  SatAnswer solve(const Run& run) {
    at_fault.clear();
    back_to(0);
    for (int lit : assumed) reserve(lit);
    const SatAnswer answer = contradicts ? SatAnswer::Unsatisfiable : search(run);
    back_to(0);
    assumed.clear();
    return answer;
  }
};

SatSolver::SatSolver() : solver_(std::make_unique<Solver>()) {}

SatSolver::~SatSolver() = default;

void SatSolver::add(const std::vector<int>& clause) { solver_->add(clause); }

void SatSolver::assume(int literal) { solver_->assumed.push_back(Solver::literal(literal)); }

SatAnswer SatSolver::solve(const Run& run) { return run.over() ? SatAnswer::RunOver : solver_->solve(run); }

bool SatSolver::holds(int variable) const {
  const std::size_t lit = 2 * static_cast<std::size_t>(variable - 1);
  return lit < solver_->model.size() && solver_->model[lit] == 1;
}

bool SatSolver::is_at_fault(int literal) const {
  const std::vector<int>& at_fault = solver_->at_fault;
  return std::find(at_fault.begin(), at_fault.end(), Solver::literal(literal)) != at_fault.end();
}

}  // namespace plico
