#include "plico/workflow/jobs/job_files.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "plico/base/error.h"
#include "plico/io/text/file.h"
#include "plico/workflow/jobs/suggest.h"

namespace plico::jobs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_existing(const std::string& path) {
  throw FileError("file/exists", fmt::format("{} exists already", path), path, "add --force to overwrite it");
}

[[noreturn]] void refuse_folder(const std::string& folder) {
  throw FileError("file/write", fmt::format("nothing can be written into the folder {}", folder.empty() ? "." : folder),
                  folder);
}

[[noreturn]] void refuse_full(const std::string& folder) {
  throw FileError("file/exists", fmt::format("the folder {} is not empty", folder), folder,
                  "add --force to overwrite the files in it");
}

}  // namespace

std::string quoted(const std::string& word) {
  const bool plain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) || c > 127 ||
           std::string_view("-_./:,=+%@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string DiskFiles::read(const std::string& path) {
  std::error_code error;
  if (path == "-" || fs::exists(path, error)) return read_file(path);
  const fs::path folder = fs::path(path).parent_path();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  const std::string nearest = nearest_word(fs::path(path).filename().string(), names);
  throw FileError("file/read",
                  fmt::format("cannot read {}: there is no such file{}", path,
                              did_you_mean(nearest.empty() ? "" : (folder / nearest).string())),
                  path, folder.empty() ? "ls" : "ls " + quoted(folder.string()));
}

std::vector<std::string> DiskFiles::names_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error)) names.push_back(entry.path().filename().string());
  if (error) throw FileError("file/read", fmt::format("cannot read {}: it is no folder", folder), folder);
  std::ranges::sort(names);
  return names;
}

void DiskFiles::expect_file(const std::string& path, bool overwrite) {
  if (path == "-") return;
  std::error_code error;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    throw FileError("file/no-folder", fmt::format("cannot write {}: there is no folder {}", path, folder.string()),
                    path, fmt::format("mkdir -p {}", quoted(folder.string())));
  if (fs::is_directory(path, error))
    throw FileError("file/write", fmt::format("cannot write {}: it is a folder", path), path);
  if (access(folder.empty() ? "." : folder.c_str(), W_OK) != 0 && !is_device(path)) refuse_folder(folder.string());
  if (!overwrite && fs::exists(path, error) && !is_device(path)) refuse_existing(path);
}

void DiskFiles::make_folder(const std::string& path, bool must_be_empty) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw FileError("file/not-a-folder", fmt::format("{} is not a folder", path), path);
  if (must_be_empty && fs::is_directory(path, error) && !fs::is_empty(path, error)) refuse_full(path);
  if (fs::is_directory(path, error) && access(path.c_str(), W_OK) != 0) refuse_folder(path);
  fs::create_directories(path, error);
  if (error) throw FileError("file/write", fmt::format("cannot make the folder {}: {}", path, error.message()), path);
}

void DiskFiles::write(const std::string& path, std::string_view bytes, bool overwrite) {
  write_file(path, bytes, overwrite);
}

std::string MemoryFiles::read(const std::string& path) {
  const auto found = files.find(path);
  if (found == files.end())
    throw FileError("file/read", fmt::format("cannot read {}: there is no such file", path), path);
  return found->second;
}

std::vector<std::string> MemoryFiles::names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& [path, bytes] : files)
    if (path.starts_with(folder + "/") && path.find('/', folder.size() + 1) == std::string::npos)
      names.push_back(path.substr(folder.size() + 1));
  if (names.empty()) throw FileError("file/read", fmt::format("cannot read {}: it is no folder", folder), folder);
  return names;
}

void MemoryFiles::expect_file(const std::string& path, bool overwrite) {
  if (!overwrite && files.contains(path)) refuse_existing(path);
}

void MemoryFiles::make_folder(const std::string& path, bool must_be_empty) {
  const auto inside = files.lower_bound(path + "/");
  if (must_be_empty && inside != files.end() && inside->first.starts_with(path + "/")) refuse_full(path);
}

void MemoryFiles::write(const std::string& path, std::string_view bytes, bool overwrite) {
  expect_file(path, overwrite);
  files[path] = bytes;
}

}  // namespace plico::jobs
