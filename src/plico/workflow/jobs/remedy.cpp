#include "plico/workflow/jobs/remedy.h"

#include <fmt/format.h>

#include <regex>
#include <string_view>

#include "plico/workflow/jobs/job_files.h"

namespace plico::jobs {
namespace {

// A code, or the beginning of all codes of a family. FILE is the input, JOB the job's name.
struct Rule {
  std::string_view codes, remedy;
};

constexpr std::string_view kAnotherForm = "plico origami make miura -o miura.fold, to see a file that can be read";

constexpr Rule kRules[] = {
    {"usage/option", "plico JOB --help"},
    {"read/empty", "plico sample bird -o bird.obj, for a mesh to begin with"},
    {"read/", "export the file again, or as OBJ"},
    {"mesh/empty", "export the model with its faces: points have no surface"},
    {"mesh/too-many-faces", "make it smaller where it was made, to 200,000 faces or so"},
    {"mesh/", "plico check FILE --repair -o repaired.obj"},
    {"file/too-large", "make it smaller where it was made"},
    {"file/not-a-folder", "choose another folder with -o"},
    {"file/write", "choose another place with -o"},
    {"file/read", "ls"},
    {"write/", "write it as OBJ"},
    {"shell/no-parts", "export the model with its faces: points have no surface"},
    {"shell/", "plico check FILE --repair -o repaired.obj"},
    {"segment/", "plico segment FILE -o parts.fold"},
    {"fold/limits", "plico fold FILE -o motion.fold"},
    {"fold/no-mesh", "plico unfold MESH -o net.fold"},
    {"fold/mesh-numbers", "plico unfold MESH -o net.fold"},
    {"fold/folded-form", "plico unfold MESH -o net.fold"},
    {"fold/parts", "plico craft MESH --parts auto -o kit"},
    {"fold/piece", "plico craft MESH --parts auto -o kit"},
    {"fold/joints", "plico craft MESH --shells -o kit"},
    {"fold/", kAnotherForm},
    {"cp/", kAnotherForm},
    {"opx/", kAnotherForm},
    {"ori/", kAnotherForm},
    {"trj/", kAnotherForm},
    {"svg/", kAnotherForm},
    {"pattern/empty", "draw mountains #f00, valleys #00f, the border #000"},
    {"pattern/size", "take out lines that are no creases"},
    {"pattern/tangled", "join line ends over a larger distance: add --merge LENGTH"},
    {"gallery/empty", "plico origami make miura -o FILE/miura.fold"},
    {"origami/", "plico origami info FILE"},
    {"motion/", "plico fold FILE -o motion.fold"},
    {"chain/", "plico stack MESH -o stack.fold"},
    {"stack/", "plico stack FILE --cells 30 -o stack.fold"},
    {"picture/", "add --no-color"},
    {"project/", "plico studio MESH"},
    {"fabricate/part-too-large", "add --split"},
    {"fabricate/", "plico origami info FILE"},
    {"linkage/empty", "plico origami info FILE"},
    {"inflate/", "plico check FILE --repair -o repaired.obj"},
    {"simplify/", "plico check FILE --repair -o repaired.obj"},
    {"unfold/", "plico check FILE"},
    {"verify/", "plico unfold MESH -o net.fold"},
};

// The command that shows the place: "NAME:17", "NAME:1:3044" (a column, of long lines), "NAME: byte 80".
std::string look_at(const std::string& where) {
  static const std::regex place(R"((.+?)(?:: byte (\d+)|:(\d+)(?::(\d+))?)(?:\D.*)?)");
  std::smatch found;
  if (!std::regex_match(where, found, place) || found[1] == "-" || found[1] == "input") return {};
  const std::string file = quoted(found[1]);
  if (found[2].matched) return fmt::format("od -A d -c -j {} -N 64 {}", found[2].str(), file);
  const std::string line = fmt::format("sed -n {}p {}", found[3].str(), file);
  if (!found[4].matched) return line;
  const long column = std::stol(found[4]);
  return fmt::format("{} | cut -c {}-{}", line, std::max(1L, column - 40), column + 40);
}

std::string with(std::string text, std::string_view word, const std::string& meant) {
  if (const auto at = text.find(word); at != std::string::npos) text.replace(at, word.size(), meant);
  return text;
}

}  // namespace

std::string remedy(const Error& error, const Attempt& attempt) {
  if (!error.suggestion().empty()) return error.suggestion();
  for (const Rule& rule : kRules) {
    if (!error.code().starts_with(rule.codes)) continue;
    if (rule.codes == "usage/option" && attempt.job.empty()) return "plico --help";
    if (!rule.codes.ends_with("empty"))
      if (std::string look = look_at(error.where()); !look.empty()) return look;
    const std::string file = attempt.input.empty() || attempt.input == "-" ? "FILE" : quoted(attempt.input);
    return with(with(std::string(rule.remedy), "FILE", file), "JOB", attempt.job);
  }
  return {};
}

}  // namespace plico::jobs
