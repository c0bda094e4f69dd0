// Where a job finds its inputs and leaves its results: the disk, or memory (a page in a browser, a test).
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace plico::jobs {

class JobFiles {
 public:
  virtual ~JobFiles() = default;

  /// All bytes of a file; "-" is standard input. Throws FileError.
  virtual std::string read(const std::string& path) = 0;
  /// The names of the files directly in a folder, sorted. Throws FileError when it is none.
  virtual std::vector<std::string> names_in(const std::string& folder) = 0;
  /// Throws FileError when `path` could not be written, or exists and may not be overwritten.
  virtual void expect_file(const std::string& path, bool overwrite) = 0;
  /// Makes a folder where there is none. Throws FileError when that fails, or when it `must_be_empty` and is not.
  virtual void make_folder(const std::string& path, bool must_be_empty) = 0;
  /// Writes a whole file or nothing; "-" is standard output. Throws FileError.
  virtual void write(const std::string& path, std::string_view bytes, bool overwrite) = 0;
};

/// The files of this computer.
class DiskFiles final : public JobFiles {
 public:
  std::string read(const std::string& path) override;
  std::vector<std::string> names_in(const std::string& folder) override;
  void expect_file(const std::string& path, bool overwrite) override;
  void make_folder(const std::string& path, bool must_be_empty) override;
  void write(const std::string& path, std::string_view bytes, bool overwrite) override;
};

/// Files by path, in memory. Every path with a slash is taken to be in a folder that exists.
class MemoryFiles final : public JobFiles {
 public:
  std::map<std::string, std::string> files;

  std::string read(const std::string& path) override;
  std::vector<std::string> names_in(const std::string& folder) override;
  void expect_file(const std::string& path, bool overwrite) override;
  void make_folder(const std::string& path, bool must_be_empty) override;
  void write(const std::string& path, std::string_view bytes, bool overwrite) override;
};

/// A word as a shell reads it back.
std::string quoted(const std::string& word);

}  // namespace plico::jobs
