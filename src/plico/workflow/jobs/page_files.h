// Pages as files: what is shared by commands that draw.
#pragma once
#include <string>
#include <vector>

#include "plico/io/page/drawing.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// One PDF of all pages, or one .svg or .dxf a page: "bunny.svg" for the only one, else "bunny-1.svg", "bunny-2.svg" ...
// With `one_svg` one SVG of all pages, too.
void write_pages(Session& session, const std::string& path, const std::vector<Drawing>& pages, const std::string& title,
                 bool one_svg = false);

}  // namespace plico::jobs
