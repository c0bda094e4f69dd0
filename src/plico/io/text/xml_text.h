// Text that goes into XML: drawings with titles from file names.
#pragma once
#include <string>
#include <string_view>

namespace plico {

// As text or attribute value of an XML document; control characters, which no document may hold, are left out.
std::string xml_text(std::string_view text);

}  // namespace plico
