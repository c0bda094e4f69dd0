// plico studio: the studio's page with a file inside. Not one of all_jobs(): only a program on a computer has a page
// that was built beside it, and a browser to show it in.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "plico/workflow/jobs/job.h"

namespace plico::jobs {

/// What the program that offers the studio knows of its computer.
struct StudioPlace {
  std::string page;                              // path of the built page; empty when there is none
  std::string expected_at;                       // where it would be, for the message
  std::function<bool(const std::string&)> show;  // opens a path in a browser; false when that did not work
};

/// The page with a file in it, which it opens by itself. Throws FileError when `page` has no place for one.
std::string studio_page(std::string_view page, const std::string& name, std::string_view bytes);

Job studio_job(const StudioPlace& place);

}  // namespace plico::jobs
