#include "plico/io/text/xml.h"

#include <algorithm>

#include "plico/base/error.h"

namespace plico {

XmlFile::XmlFile(std::string_view bytes, std::string name) : name_(std::move(name)) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (bytes[i] == '\n') line_ends_.push_back(static_cast<std::ptrdiff_t>(i));
  const pugi::xml_parse_result parsed =
      document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed)
    throw InvalidInput("read/xml", fmt::format("the file is not well-formed XML ({})", parsed.description()),
                       fmt::format("{}:{}", name_, line_at(parsed.offset)));
}

int XmlFile::line_at(std::ptrdiff_t byte) const {
  return static_cast<int>(std::lower_bound(line_ends_.begin(), line_ends_.end(), byte) - line_ends_.begin()) + 1;
}

int XmlFile::line(const pugi::xml_node& node) const { return line_at(node.offset_debug()); }

std::string XmlFile::place(const pugi::xml_node& node) const { return fmt::format("{}:{}", name_, line(node)); }

void XmlFile::check_depth(const pugi::xml_node& node, int depth) const {
  if (depth > kDeepest)
    throw InvalidInput("read/xml", fmt::format("elements are nested more than {} levels deep", kDeepest), place(node));
}

}  // namespace plico
