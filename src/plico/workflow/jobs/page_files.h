// Pages as files: what is shared by commands that draw.
#pragma once
#include <string>
#include <vector>

#include "plico/io/page/drawing.h"
#include "plico/workflow/jobs/session.h"

namespace plico::jobs {

// "bunny.svg" as "bunny-2.svg" when it is the second (from 0: 1) of several, as it is when it is the only one.
std::string numbered_path(const std::string& path, std::size_t which, std::size_t of);

// One PDF of all pages, or one .svg or .dxf a page: "bunny.svg" for the only one, else "bunny-1.svg", "bunny-2.svg" ...
// With `one_svg` one SVG of all pages, too.
void write_pages(Session& session, const std::string& path, const std::vector<Drawing>& pages, const std::string& title,
                 bool one_svg = false);

}  // namespace plico::jobs
