// Instead of cairo and QPDF: no PDF. SVG holds the same pages.
#include "plico/io/page/pdf.h"

#include "plico/base/error.h"

namespace plico {

std::string write_pdf(const std::vector<Drawing>&, const std::string&, const std::string&) {
  throw InvalidOption("pdf is not in this build", "use .svg or .dxf, or the program on a computer: plico print");
}

}  // namespace plico
