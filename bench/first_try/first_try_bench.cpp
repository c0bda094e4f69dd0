// The first command that somebody tries, on files as they are: plico craft FILE into a fresh folder, for every mesh of
// a folder. It succeeds, or refuses with a code, a place and a command to try; exit 70, a bug of ours, never.
//   bench_first_try --program PLICO --meshes DIR [--limit SECONDS] [--json FILE] [--quick]
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <sstream>

#include "plico/workflow/jobs/job_files.h"
#include "table.h"

namespace plico::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kBug = 70, kKilled = 124;  // of plico, of timeout(1)

struct FirstTry {
  int exit_code = 0;
  double seconds = 0;
  json told;  // what --json printed; null when that was no JSON
};

std::string output_of(const std::string& command, int& exit_code) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return text;
  char buffer[1 << 14];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  const int status = pclose(pipe);
  exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return text;
}

FirstTry first_try(const std::string& program, const fs::path& mesh, const fs::path& folder, double limit) {
  fs::remove_all(folder);
  const std::string command =
      fmt::format("timeout {:g} {} craft {} -o {} --json 2>/dev/null", limit, jobs::quoted(program),
                  jobs::quoted(mesh.string()), jobs::quoted(folder.string()));
  FirstTry result;
  std::string text;
  result.seconds = seconds([&] { text = output_of(command, result.exit_code); });
  result.told = json::parse(text, nullptr, false);
  if (result.told.is_discarded()) result.told = nullptr;
  return result;
}

// "verified" when every claim of the answer was judged and holds.
std::string verdict(const FirstTry& tried) {
  if (tried.exit_code == kKilled) return "over the time limit";
  if (!tried.told.is_object()) return "no answer";
  if (tried.told.contains("error")) return tried.told["error"].value("code", "no code");
  const json craft = tried.told.value("craft", json::object());
  return craft.value("net_verified", false) && craft.value("pages_verified", false) ? "verified" : "NOT VERIFIED";
}

json pages(const FirstTry& tried) {
  if (!tried.told.is_object() || !tried.told.contains("craft")) return nullptr;
  return tried.told["craft"].value("pages", json());
}

std::string motion(const FirstTry& tried) {
  if (!tried.told.is_object() || !tried.told.contains("craft")) return "-";
  const json& craft = tried.told["craft"];
  if (!craft.contains("motion")) return craft.value("no_motion", "none");
  const std::string kind = craft["motion"].value("kind", "pieces"), proof = craft["motion"].value("verdict", "");
  return kind + ", " + (proof == "free" ? "proven" : proof);
}

struct Totals {
  int files = 0, verified = 0, told_what_helps = 0, refused_with_remedy = 0, refused_without = 0, bugs = 0, late = 0;
  int other = 0;
};

std::string told_of_error(const FirstTry& tried, const char* what) {
  if (!tried.told.is_object() || !tried.told.contains("error")) return "";
  return tried.told["error"].value(what, "");
}

// Of an answer without a motion.
std::string to_try(const FirstTry& tried) {
  if (!tried.told.is_object() || !tried.told.contains("craft")) return "";
  return tried.told["craft"].value("try", "");
}

void count(const FirstTry& tried, Totals& totals) {
  ++totals.files;
  const bool error = tried.told.is_object() && tried.told.contains("error");
  if (tried.exit_code == kBug)
    ++totals.bugs;
  else if (tried.exit_code == kKilled)
    ++totals.late;
  else if (error)
    ++(told_of_error(tried, "where").empty() || told_of_error(tried, "suggestion").empty()
           ? totals.refused_without
           : totals.refused_with_remedy);
  else if (verdict(tried) == "verified")
    ++(tried.exit_code == 0 ? totals.verified : to_try(tried).empty() ? totals.other : totals.told_what_helps);
  else
    ++totals.other;
}

int bench(const Arguments& args, const std::string& program, double limit) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("plico-first-try-{}", getpid());
  Table table("plico craft FILE, as the files are", {"file", "faces", "exit", "answer", "motion", "pages", "s"});
  Totals totals;
  for (const fs::path& mesh : mesh_files(args.meshes)) {
    if (args.quick && totals.files >= 5) break;
    const FirstTry tried = first_try(program, mesh, folder, limit);
    if (const std::string remedy = to_try(tried); !remedy.empty()) fmt::print("  try:   {}\n", remedy);
    const json craft = tried.told.is_object() ? tried.told.value("craft", json::object()) : json::object();
    table.row({mesh.filename().string(), craft.value("faces", json()), tried.exit_code, verdict(tried), motion(tried),
               pages(tried), tried.seconds});
    if (const std::string where = told_of_error(tried, "where"); !where.empty()) fmt::print("  where: {}\n", where);
    if (const std::string remedy = told_of_error(tried, "suggestion"); !remedy.empty())
      fmt::print("  try:   {}\n", remedy);
    count(tried, totals);
  }
  fs::remove_all(folder);
  fmt::print(
      "{} files: {} verified, {} more verified but not found to fold, with what to try, {} refused with place and "
      "remedy, {} refused without, {} over the limit of {:g} s, "
      "{} other answers, {} exits with {}\n",
      totals.files, totals.verified, totals.told_what_helps, totals.refused_with_remedy, totals.refused_without,
      totals.late, limit, totals.other, totals.bugs, kBug);
  write_json(args, {&table});
  return totals.bugs == 0 ? 0 : 1;
}

}  // namespace
}  // namespace plico::bench

int main(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  const std::string program = plico::bench::taken(words, "--program");
  const std::string limit = plico::bench::taken(words, "--limit");
  const auto args = plico::bench::arguments(static_cast<int>(words.size()), words.data());
  if (program.empty() || args.meshes.empty()) {
    fmt::print(stderr, "usage: {} --program PLICO --meshes DIR [--limit SECONDS] [--json FILE] [--quick]\n", argv[0]);
    return 2;
  }
  return plico::bench::bench(args, program, limit.empty() ? 60 : std::atof(limit.c_str()));
}
