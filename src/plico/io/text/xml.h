// XML documents with the line of every element, for the readers in this folder only.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace plico {

class XmlFile {
 public:
  // Throws InvalidInput "read/xml" with file and line. Entities that the file declares are not expanded.
  XmlFile(std::string_view bytes, std::string name);

  pugi::xml_node root() const { return document_.document_element(); }
  int line(const pugi::xml_node& node) const;           // from 1
  std::string place(const pugi::xml_node& node) const;  // "file:line"

  // Children, in their order; throws InvalidInput "read/xml" beyond 200 levels.
  static constexpr int kDeepest = 200;
  void check_depth(const pugi::xml_node& node, int depth) const;

 private:
  int line_at(std::ptrdiff_t byte) const;

  std::string name_;
  std::vector<std::ptrdiff_t> line_ends_;
  pugi::xml_document document_;
};

}  // namespace plico
