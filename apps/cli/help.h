// What --help prints.
#pragma once
#include <string>
#include <vector>

#include "command.h"

namespace plico::cli {

std::string program_help(const std::vector<Command>& commands);
std::string group_help(const std::vector<Command>& group);  // of commands with the same first word
std::string command_help(const Command& command);

// `text` broken at spaces so that no line, indented by `indent`, is longer than `width`; the first line is not
// indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

// Parts that the man page and the completions share with --help.
std::string usage_line(const Command& command);  // "plico unfold [options] MESH"
std::string shown_name(const Option& option);    // "MESH", "-o, --output FILE"
std::string full_help(const Option& option);     // help, choices and default
std::vector<std::pair<std::string, std::string>> program_examples();
std::vector<std::pair<int, std::string>> exit_codes();

}  // namespace plico::cli
