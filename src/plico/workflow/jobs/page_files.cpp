#include "plico/workflow/jobs/page_files.h"

#include <fmt/format.h>

#include "plico/base/version.h"
#include "plico/io/page/dxf.h"
#include "plico/io/page/pdf.h"
#include "plico/io/page/svg.h"
#include "plico/io/text/file.h"

namespace plico::jobs {

std::string numbered_path(const std::string& path, std::size_t which, std::size_t of) {
  if (of == 1) return path;
  const std::size_t dot = path.size() - extension(path).size() - 1;
  return fmt::format("{}-{}{}", path.substr(0, dot), which + 1, path.substr(dot));
}

void write_pages(Session& session, const std::string& path, const std::vector<Drawing>& pages, const std::string& title,
                 bool one_svg) {
  const std::string kind = extension(path);
  if (path == "-" || kind == "pdf") {
    session.write(path, write_pdf(pages, title, fmt::format("plico {}", plico::version())));
    return;
  }
  if (kind == "svg" && one_svg) {
    session.write(path, write_svg(pages));
    return;
  }
  for (std::size_t i = 0; i < pages.size(); ++i)
    session.write(numbered_path(path, i, pages.size()), kind == "svg" ? write_svg(pages[i]) : write_dxf(pages[i]));
}

}  // namespace plico::jobs
