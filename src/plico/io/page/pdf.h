// PDF 1.5 with named layers (optional content groups) and text that can be searched. Source: ISO 32000-1.
#pragma once
#include <string>
#include <vector>

#include "plico/io/page/drawing.h"

namespace plico {

// One drawing a page, at true size; viewers are told not to scale when printing. Layers CUT, MOUNTAIN, VALLEY, MARK,
// TEXT can be shown and hidden. `title` and `creator` go into the document's information. Deterministic bytes.
std::string write_pdf(const std::vector<Drawing>& pages, const std::string& title, const std::string& creator);

}  // namespace plico
