// Several files in one: ZIP archives, written as 3MF and other containers have them.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace plico {

// The bytes of an archive of these files, name (with / between folders) and content, in this order; deflated. No time
// is told, so that the same files make the same bytes. Throws InvalidInput beyond the 4 GB that the format counts to.
std::string write_zip(const std::vector<std::pair<std::string, std::string>>& files);

}  // namespace plico
