// What --help prints.
#pragma once
#include <string>
#include <vector>

#include "plico/workflow/jobs/job.h"

namespace plico::cli {

using jobs::Job;
using jobs::Option;

std::string program_help(const std::vector<Job>& commands);
std::string group_help(const std::vector<Job>& group);  // of commands with the same first word
std::string command_help(const Job& command);

// `text` broken at spaces so that no line, indented by `indent`, is longer than `width`; the first line is not
// indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

// Parts that the man page and the completions share with --help.
std::string usage_line(const Job& command);    // "plico unfold [options] MESH"
std::string shown_name(const Option& option);  // "MESH", "-o, --output FILE"
std::string full_help(const Option& option);   // help, choices and default
std::vector<std::pair<std::string, std::string>> program_examples();
std::vector<std::pair<int, std::string>> exit_codes();

}  // namespace plico::cli
