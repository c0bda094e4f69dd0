#include "plico/workflow/jobs/studio.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"
#include "plico/io/text/file.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/open_project.h"

namespace plico::jobs {
namespace {

// Where studio/build_page.mjs leaves room for a file.
constexpr std::string_view kNoFile = R"(id="inlined">null</script>)";
constexpr std::string_view kFileStart = R"(id="inlined">)", kFileEnd = "</script>";

// A browser holds the page, its text and the bytes at the same time.
constexpr std::size_t kMaxBytes = 100'000'000;

struct StudioArgs {
  std::string file;
  bool no_open = false;
};

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view three = bytes.substr(i, 3);
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < three.size() ? static_cast<unsigned char>(three[k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= three.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// JSON that cannot end the script element it stands in.
std::string file_json(const std::string& name, std::string_view bytes) {
  const nlohmann::json file{{"name", name}, {"bytes", base64(bytes)}};
  std::string text;
  for (char c : file.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
    c == '<' ? text += "\\u003c" : text += c;
  return text;
}

// What the page could not open is told here, where it can be mended.
std::string checked_file(const std::string& path, Session& session) {
  std::string bytes = session.read(path);
  if (bytes.size() > kMaxBytes)
    throw InvalidInput("studio/large",
                       fmt::format("{} has {} bytes, at most {} fit into a page", path, bytes.size(), kMaxBytes), path,
                       fmt::format("plico simplify {} --faces 20000 -o small.obj", quoted(path)));
  open_project(bytes, path);
  return bytes;
}

std::string built_page(const StudioPlace& place, Session& session) {
  if (place.page.empty())
    throw FileError("studio/not-built", "the studio's page was not built with this program", place.expected_at,
                    "setup/build-studio, in the folder of Plico's sources");
  return session.read(place.page);
}

void show(const StudioPlace& place, const std::string& path, Session& session) {
  if (path == "-") return;
  if (!place.show || !place.show(path)) session.say(fmt::format("open {} in a browser", path));
}

int write_studio(const StudioArgs& args, const StudioPlace& place, Session& session) {
  const std::filesystem::path file(args.file == "-" ? "" : args.file);
  const std::vector<std::string> outputs =
      session.outputs(file.empty() ? "plico-studio.html" : file.stem().string() + "-studio.html");
  std::string page = built_page(place, session);
  if (!args.file.empty())
    page = studio_page(page, file.empty() ? "model.obj" : file.filename().string(), checked_file(args.file, session));
  for (const std::string& path : outputs) session.write(path, page);
  session.report()["bytes"] = page.size();
  session.say(fmt::format("{:.1f} MB, works offline", static_cast<double>(page.size()) / 1e6));
  if (!args.no_open && !outputs.empty()) show(place, outputs.front(), session);
  return kDone;
}

}  // namespace

std::string studio_page(std::string_view page, const std::string& name, std::string_view bytes) {
  const std::size_t place = page.find(kNoFile);
  if (place == std::string_view::npos)
    throw FileError("studio/page", "the studio's page has no place for a file", {}, "setup/build-studio");
  std::string text(page.substr(0, place));
  text += kFileStart;
  text += file_json(name, bytes);
  text += kFileEnd;
  text += page.substr(place + kNoFile.size());
  return text;
}

Job studio_job(const StudioPlace& place) {
  const auto args = std::make_shared<StudioArgs>();
  return Job("studio", "Write the studio, one page that works offline, with a file inside, and open it in the browser")
      .example("plico studio bird.obj", "write bird-studio.html and open it")
      .example("plico studio net.fold -o net.html --no-open", "only write it, to keep or to send")
      .example("plico studio", "the studio without a file")
      .positional("file", "mesh, net with its folded form (FOLD) or project (.plico)", args->file, false)
      .flag("--no-open", "do not open the page in a browser", args->no_open)
      .action([args, place](Session& session) { return write_studio(*args, place, session); });
}

}  // namespace plico::jobs
