// What every bench program does: read its arguments, time things, print a table while it runs and write it as JSON.
//   bench_NAME [--meshes DIR] [--json FILE] [--quick]
#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plico::bench {

struct Arguments {
  std::string meshes;  // a folder; empty: only the project's own shapes
  std::string json;    // a file; empty: none
  bool quick = false;  // fewer and smaller rows
};

inline Arguments arguments(int argc, char** argv) {
  Arguments result;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--quick") {
      result.quick = true;
    } else if ((word == "--meshes" || word == "--json") && i + 1 < argc) {
      (word == "--json" ? result.json : result.meshes) = argv[++i];
    } else {
      fmt::print(stderr, "usage: {} [--meshes DIR] [--json FILE] [--quick]\n", argv[0]);
      std::exit(2);
    }
  }
  return result;
}

// The value of an option of this program alone, taken out of the words.
inline std::string taken(std::vector<char*>& words, std::string_view option) {
  const auto at = std::find_if(words.begin(), words.end(), [&](const char* word) { return option == word; });
  if (words.end() - at < 2) return {};
  const std::string value = at[1];
  words.erase(at, at + 2);
  return value;
}

// The mesh files of a folder in order of name; none when `folder` is empty.
inline std::vector<std::filesystem::path> mesh_files(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  if (folder.empty()) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string ext = entry.path().extension();
    if (ext == ".obj" || ext == ".off" || ext == ".stl" || ext == ".ply") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Wall seconds that `work` takes.
template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  std::forward<Work>(work)();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Seconds of all processors: a busy machine changes them little.
template <class Work>
double processor_seconds(Work&& work) {
  const std::clock_t start = std::clock();
  std::forward<Work>(work)();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// The higher of the two middle ones; 0 of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// A cell is a name or a number; null is shown as "-" (the dissertation has no such row).
class Table {
 public:
  using Row = std::vector<nlohmann::json>;

  Table(std::string title, std::vector<std::string> columns) : title_(std::move(title)), columns_(std::move(columns)) {
    fmt::print("{}\n", title_);
    print(Row(columns_.begin(), columns_.end()));
  }

  // Printed at once, so that a long run can be watched.
  void row(Row cells) {
    print(cells);
    rows_.push_back(std::move(cells));
  }

  nlohmann::json to_json() const {
    nlohmann::json rows = nlohmann::json::array();
    for (const Row& cells : rows_) {
      nlohmann::json object;
      for (std::size_t i = 0; i < cells.size(); ++i) object[columns_[i]] = cells[i];
      rows.push_back(std::move(object));
    }
    return {{"title", title_}, {"rows", std::move(rows)}};
  }

 private:
  void print(const Row& cells) const {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::size_t width = std::max<std::size_t>(i == 0 ? 24 : 9, columns_[i].size());
      const std::string text = shown(cells[i]);
      if (i == 0)
        fmt::print("{:<{}}", text, width);
      else
        fmt::print("  {:>{}}", text, width);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }

  static std::string shown(const nlohmann::json& cell) {
    if (cell.is_null()) return "-";
    if (cell.is_string()) return cell.get<std::string>();
    if (cell.is_number_float()) return fmt::format("{:.4g}", cell.get<double>());
    return cell.dump();
  }

  std::string title_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

// Writes the tables to the file that --json names, if any.
inline void write_json(const Arguments& arguments, const std::vector<const Table*>& tables) {
  if (arguments.json.empty()) return;
  nlohmann::json all = nlohmann::json::array();
  for (const Table* table : tables) all.push_back(table->to_json());
  std::ofstream(arguments.json) << all.dump(2) << "\n";
}

}  // namespace plico::bench
