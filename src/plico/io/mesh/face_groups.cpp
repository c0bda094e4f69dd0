#include "plico/io/mesh/face_groups.h"

#include <map>

#include "plico/base/error.h"
#include "plico/io/text/text_scanner.h"

namespace plico {
namespace {

class GroupList {
 public:
  void add_face(const std::string& group) {
    const auto [at, is_new] = number_.try_emplace(group, static_cast<int>(groups.names.size()));
    if (is_new) groups.names.push_back(group);
    groups.of_face.push_back(at->second);
  }

  FaceGroups groups;

 private:
  std::map<std::string, int> number_;
};

std::string words_of_line(TextScanner& scan) {
  std::string words;
  while (scan.more_on_line()) words += (words.empty() ? "" : " ") + std::string(scan.word());
  return words;
}

}  // namespace

FaceGroups read_obj_groups(std::string_view bytes, const std::string& name) {
  TextScanner scan(bytes, name);
  GroupList by_group, by_object;
  std::string group, object;
  bool has_groups = false, has_objects = false;
  while (scan.more()) {
    const std::string_view keyword = scan.word();
    if (keyword == "f") {
      by_group.add_face(group);
      by_object.add_face(object);
    } else if (keyword == "g") {
      group = words_of_line(scan);
      has_groups = true;
    } else if (keyword == "o") {
      object = words_of_line(scan);
      has_objects = true;
    }
    while (scan.more_on_line()) scan.word();
  }
  if (!has_groups && !has_objects)
    throw InvalidInput("segment/no-groups", "the file names no groups of faces", name,
                       "plico segment --by components, or --labels FILE");
  return has_groups ? by_group.groups : by_object.groups;
}

FaceGroups read_face_labels(std::string_view bytes, const std::string& name) {
  TextScanner scan(bytes, name);
  GroupList labels;
  while (scan.more()) {
    labels.add_face(std::string(scan.word()));
    if (scan.more_on_line()) scan.fail("read/syntax", "a line has more than one label");
  }
  return labels.groups;
}

}  // namespace plico
