#include "plico/segment/wishes.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>

#include "plico/base/error.h"

namespace plico {
namespace {

[[noreturn]] void refuse_list(std::string_view option, const std::string& text) {
  throw InvalidOption(fmt::format("{} = {} must be faces such as 3,17-20", option, text));
}

// The number at the front of `text`, which is taken off; -1 for none.
int take_number(std::string_view& text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || value < 0) return -1;
  text.remove_prefix(end - text.data());
  return value;
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

void check_groups(const std::vector<std::vector<int>>& groups, std::string_view option, int num_faces) {
  for (const std::vector<int>& group : groups) {
    if (group.size() < 2)
      throw InvalidOption(fmt::format("{} = {} must name two faces or more", option, group.front()));
    for (int f : group) require(f < num_faces, option, f, fmt::format("below {}, the number of faces", num_faces));
  }
}

// The shortest ways from one face to all others that go over no face of `closed`: the face before each, -1 for none.
std::vector<int> ways_from(const DualGraph& graph, int from, const std::set<int>& closed) {
  using Entry = std::pair<double, int>;
  std::vector<double> distance(graph.num_faces(), std::numeric_limits<double>::infinity());
  std::vector<int> before(graph.num_faces(), -1);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[from] = 0;
  queue.emplace(0, from);
  while (!queue.empty()) {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d > distance[f]) continue;
    for (const DualGraph::Arc& arc : graph.arcs(f))
      if (!closed.contains(arc.to) && d + arc.distance < distance[arc.to])
        distance[arc.to] = d + arc.distance, before[arc.to] = f, queue.emplace(distance[arc.to], arc.to);
  }
  return before;
}

std::set<int> apart_from(const FaceWishes& wishes, const std::vector<int>& group) {
  std::set<int> faces;
  for (const auto& [a, b] : pairs_apart(wishes)) {
    if (std::count(group.begin(), group.end(), a)) faces.insert(b);
    if (std::count(group.begin(), group.end(), b)) faces.insert(a);
  }
  return faces;
}

[[noreturn]] void refuse_name(const std::string& what, const std::string& name, int line) {
  throw InvalidInput("segment/names", what, fmt::format("{}:{}", name, line),
                     "give lines of a face and the name of its part, such as 17 head");
}

}  // namespace

std::vector<int> face_list(const std::string& text, std::string_view option) {
  constexpr int kMostFaces = 100'000'000;
  std::set<int> faces;
  std::string_view rest = text;
  do {
    const int first = take_number(rest);
    const int last = take(rest, '-') ? take_number(rest) : first;
    if (first < 0 || last < first || last > kMostFaces) refuse_list(option, text);
    for (int f = first; f <= last; ++f) faces.insert(f);
  } while (take(rest, ','));
  if (!rest.empty()) refuse_list(option, text);
  return {faces.begin(), faces.end()};
}

void check(const FaceWishes& wishes, int num_faces) {
  check_groups(wishes.keep, "keep", num_faces);
  check_groups(wishes.apart, "apart", num_faces);
  const std::vector<std::pair<int, int>> pairs = pairs_apart(wishes);
  for (const std::vector<int>& group : wishes.keep)
    for (const auto& [a, b] : pairs)
      if (std::binary_search(group.begin(), group.end(), a) && std::binary_search(group.begin(), group.end(), b))
        throw InvalidOption(fmt::format("faces {} and {} cannot be kept together and come apart", a, b));
}

std::vector<std::pair<int, int>> pairs_apart(const FaceWishes& wishes) {
  std::set<std::pair<int, int>> pairs;
  for (const std::vector<int>& group : wishes.apart)
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = i + 1; j < group.size(); ++j) pairs.insert(std::minmax(group[i], group[j]));
  return {pairs.begin(), pairs.end()};
}

void hold_together(DualGraph& graph, const FaceWishes& wishes) {
  for (const std::vector<int>& group : wishes.keep) {
    const std::vector<int> before = ways_from(graph, group.front(), apart_from(wishes, group));
    for (int f : group) {
      if (f != group.front() && before[f] < 0)
        throw InvalidOption(fmt::format(
            "faces {} and {} cannot be kept in one part: no way leads from one to the other", group.front(), f));
      for (; before[f] >= 0; f = before[f]) graph.hold(f, before[f]);
    }
  }
}

void check_kept(const FaceWishes& wishes, const std::vector<int>& part) {
  for (const std::vector<int>& group : wishes.keep)
    for (int f : group)
      if (part[f] != part[group.front()])
        throw InvalidOption(fmt::format(
            "faces {} and {} cannot be kept in one part: what must come apart is in their way, by --apart or "
            "since it runs through itself",
            group.front(), f));
}

void name_parts(Segmentation& parts, std::string_view bytes, const std::string& name) {
  std::map<int, std::string> given;
  for (int line = 1; !bytes.empty(); ++line) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view text = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    while (!text.empty() && (text.back() == '\r' || text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    if (text.empty()) continue;
    const int face = take_number(text);
    if (face < 0 || !take(text, ' ')) refuse_name("a line is no face with a name", name, line);
    while (take(text, ' ')) {
    }
    if (face >= static_cast<int>(parts.part.size()))
      refuse_name(fmt::format("face {} must be below {}, the number of faces", face, parts.part.size()), name, line);
    if (!given.emplace(parts.part[face], text).second)
      refuse_name(fmt::format("the part with face {} has a name already", face), name, line);
  }
  for (const auto& [part, word] : given) parts.names[part] = word;
  std::map<std::string, int> of_name;
  for (int p = 0; p < parts.num_parts(); ++p)
    if (!of_name.emplace(parts.names[p], p).second)
      throw InvalidInput("segment/names", fmt::format("two parts are called {}", parts.names[p]), name,
                         "give every part a name of its own");
}

}  // namespace plico
