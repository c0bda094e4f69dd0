// Ctrl-C and --time-limit in every phase of every long command: how long each goes on, what it leaves, its memory.
//   bench_stop --program PLICO [--only COMMAND] [--faces 20000|200000] [--json FILE] [--quick]
// A command runs once to see its phases; then it is interrupted early, in the middle and late in each of them, and
// given a time limit that ends there. Waits are of the wall clock: run it on a quiet machine.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "child.h"
#include "table.h"

namespace plico::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kWatched = 6;  // seconds of each command, phases that begin later are left out
constexpr std::array<double, 3> kMoments{0.1, 0.5, 0.9};  // of a phase
constexpr const char* kBeginning = "reading";             // what is done before the first phase is told

struct Command {
  std::string name;
  std::vector<std::string> words;  // MESH stands for the mesh, NET for a net of it
  std::string left;                // the file to judge; empty: a mesh, which plico check reads
};

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"craft", {"craft", "MESH", "-o", "out"}, "out/mesh.fold"},
      {"craft any net", {"craft", "MESH", "--foldable", "none", "-o", "out"}, "out/mesh.fold"},
      {"craft --parts auto", {"craft", "MESH", "--parts", "auto", "-o", "out"}, "out/mesh.fold"},
      {"unfold", {"unfold", "MESH", "-o", "out.fold"}, "out.fold"},
      {"unfold linear", {"unfold", "MESH", "--foldable", "linear", "-o", "out.fold"}, "out.fold"},
      {"unfold compact", {"unfold", "MESH", "--optimize", "page", "-o", "out.fold"}, "out.fold"},
      {"fold", {"fold", "NET", "-o", "out.fold"}, "out.fold"},
      {"fold lazy-prm", {"fold", "NET", "--planner", "lazy-prm", "-o", "out.fold"}, "out.fold"},
      {"segment", {"segment", "MESH", "-o", "out.fold"}, "out.fold"},
      {"segment convexity", {"segment", "MESH", "--by", "convexity", "-o", "out.fold"}, "out.fold"},
      {"shell", {"shell", "MESH", "-o", "out.obj"}, ""},
      {"stack", {"stack", "MESH", "--cells", "24", "-o", "out.fold"}, "out.fold"},
      {"simplify", {"simplify", "MESH", "--faces", "300", "-o", "out.obj"}, ""},
      {"check --repair", {"check", "MESH", "--repair", "-o", "out.obj"}, ""},
      {"inflate", {"inflate", "MESH", "-o", "out.obj"}, ""},
      {"print", {"print", "NET", "-o", "out.pdf"}, "out.pdf"},
      {"export", {"export", "NET", "-o", "out.html"}, "out.html"},
      {"verify", {"verify", "NET", "MESH"}, ""},
  };
  return all;
}

struct Worst {
  int runs = 0;
  double wait = 0, work = 0, peak_mb = 0;
  std::set<int> exits;
  std::set<std::string> left;
};

class Bench {
 public:
  Bench(const fs::path& program, int faces)
      : program_(program), room_(fs::temp_directory_path() / fmt::format("plico-stop-{}", getpid())) {
    fs::remove_all(room_);
    fs::create_directories(room_);
    mesh_ = room_ / "mesh.off";
    net_ = room_ / "net.fold";
    run({"sample", "dinosaur", "--faces", std::to_string(faces), "-o", mesh_}, 0);
    run({"unfold", mesh_, "-o", net_, "--time-limit", "60s"}, 0);
  }
  ~Bench() { fs::remove_all(room_); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // Rows of (phase, worst of it), in order of appearance.
  std::vector<std::pair<std::string, Worst>> measure(const Command& command) {
    rows_.clear();
    const Ended whole = attempt(command, kWatched, {});
    std::vector<Phase> phases = whole.phases;
    phases.insert(phases.begin(), Phase{kBeginning, 0});
    std::set<std::string> seen;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      if (phases[i].begin >= kWatched || !seen.insert(phases[i].name).second) continue;
      const double end = i + 1 < phases.size() ? phases[i + 1].begin : std::min(whole.lived - whole.wait, kWatched);
      for (double share : kMoments) attempt(command, moment(phases[i].begin, end, share), {});
      attempt(command, 0, moment(phases[i].begin, end, 0.5));
    }
    return rows_;
  }

 private:
  static double moment(double begin, double end, double share) {
    return std::max(0.03, begin + share * std::max(0.0, end - begin));
  }

  Ended run(std::vector<std::string> words, double when) {
    words.insert(words.begin(), program_);
    return run_and_interrupt(words, room_, when);
  }

  // Interrupted after `moment` seconds, or given that time limit.
  Ended attempt(const Command& command, double moment, std::optional<double> limit) {
    for (const char* name : {"out", "out.fold", "out.obj", "out.pdf", "out.html"}) fs::remove_all(room_ / name);
    std::vector<std::string> words = command.words;
    std::ranges::replace(words, std::string("MESH"), mesh_.string());
    std::ranges::replace(words, std::string("NET"), net_.string());
    words.emplace_back("-vv");
    if (limit) words.insert(words.end(), {"--time-limit", fmt::format("{:.3f}s", *limit)});
    Ended ended = run(words, moment);
    if (limit && ended.lived > *limit) {
      ended.asked = true;
      ended.wait = ended.work = ended.lived - *limit;
    }
    note(command, ended, limit ? *limit : moment);
    return ended;
  }

  void note(const Command& command, const Ended& ended, double when) {
    std::string phase = kBeginning;
    for (const Phase& p : ended.phases)
      if (p.begin <= when) phase = p.name;
    const auto there = std::ranges::find(rows_, phase, &std::pair<std::string, Worst>::first);
    Worst& row = there != rows_.end() ? there->second : rows_.emplace_back(phase, Worst{}).second;
    row.peak_mb = std::max(row.peak_mb, ended.peak_mb);
    if (!ended.asked) return;
    ++row.runs;
    row.wait = std::max(row.wait, ended.wait);
    row.work = std::max(row.work, ended.work);
    row.exits.insert(ended.exit_code);
    row.left.insert(what_is_left(command));
  }

  // "nothing"; "valid", to the judge or a program that reads it; "best so far", which the judge says is not yet right.
  std::string what_is_left(const Command& command) {
    const auto judged = [&](std::vector<std::string> words) {
      words.insert(words.end(), {"--time-limit", "30s", "-q"});
      const int code = run(std::move(words), 0).exit_code;
      return code == 0 ? "valid" : code == 1 ? "best so far" : code == 5 ? "not judged in 30 s" : "BROKEN";
    };
    if (fs::exists(room_ / "out.obj")) return judged({"check", room_ / "out.obj"});
    const fs::path left = room_ / command.left;
    if (command.left.empty() || !fs::exists(left)) return fs::exists(room_ / "out") ? "EMPTY FOLDER" : "nothing";
    if (left.extension() != ".fold") return fs::file_size(left) > 0 ? "a file" : "BROKEN";
    if (command.words[0] == "stack" || command.words[0] == "fold") return judged({"verify", left});
    return judged({"verify", left, mesh_});
  }

  std::string program_;
  fs::path room_, mesh_, net_;
  std::vector<std::pair<std::string, Worst>> rows_;
};

template <class Set>
std::string joined(const Set& set) {
  std::string text;
  for (const auto& item : set) text += fmt::format("{}{}", text.empty() ? "" : ", ", item);
  return text;
}

int bench(const Arguments& args, const std::string& program, const std::string& only, const std::string& faces_only) {
  Table table("asked to stop: longest wait by phase (goal 1 s), dinosaurs",
              {"command, phase", "faces", "runs", "wait s", "work s", "exit", "left", "peak MB"});
  for (int faces : {20'000, 200'000}) {
    if (args.quick && faces > 20'000) break;
    if (!faces_only.empty() && std::to_string(faces) != faces_only) continue;
    Bench bench(fs::absolute(program), faces);
    for (const Command& command : commands()) {
      if (!only.empty() && command.name != only) continue;
      for (const auto& [phase, worst] : bench.measure(command))
        table.row({command.name + ": " + phase, faces, worst.runs, worst.wait, worst.work, joined(worst.exits),
                   joined(worst.left), static_cast<long>(worst.peak_mb)});
    }
  }
  write_json(args, {&table});
  return 0;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  const std::string program = plico::bench::taken(words, "--program"), only = plico::bench::taken(words, "--only");
  const std::string faces = plico::bench::taken(words, "--faces");
  if (program.empty()) {
    fmt::print(stderr, "usage: {} --program PLICO [--only COMMAND] [--faces 20000|200000] [--json FILE] [--quick]\n",
               argv[0]);
    return 2;
  }
  return plico::bench::bench(plico::bench::arguments(static_cast<int>(words.size()), words.data()), program, only,
                             faces);
}
