// plico completions: what a shell needs to complete commands, options and choices, from the same table as --help.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <set>

#include "commands.h"
#include "plico/workflow/jobs/session.h"
#include "plico/workflow/jobs/shared_options.h"

namespace plico::cli {
namespace {

// A command with all rows of its table; commands of two words ("origami info") are a group and a member.
struct Entry {
  std::string name, summary, group, member;
  std::vector<Option> options;
};

std::vector<Entry> entries(const std::vector<Job>& commands, jobs::SharedOptions& shared) {
  std::vector<Entry> result;
  for (const Job& command : commands) {
    const auto space = command.name.find(' ');
    const bool grouped = space != std::string::npos;
    result.push_back({command.name, command.summary, command.name.substr(0, space),
                      grouped ? command.name.substr(space + 1) : "", with_shared_options(command, shared)});
  }
  return result;
}

// First words in the order of --help, each once.
std::vector<std::string> first_words(const std::vector<Entry>& all) {
  std::vector<std::string> words;
  std::set<std::string> seen;
  for (const Entry& entry : all)
    if (seen.insert(entry.group).second) words.push_back(entry.group);
  return words;
}

std::vector<std::string> members(const std::vector<Entry>& all, const std::string& group) {
  std::vector<std::string> words;
  for (const Entry& entry : all)
    if (entry.group == group && !entry.member.empty()) words.push_back(entry.member);
  return words;
}

// In single quotes of a shell; `also` are characters to be backslashed on top.
std::string quoted(const std::string& text, std::string_view also = "") {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (also.find(c) != std::string_view::npos)
      result += std::string("\\") + c;
    else
      result += c;
  }
  return result + "'";
}

std::string bash_option_values(const Entry& entry) {
  std::string text;
  for (const Option& option : entry.options) {
    if (option.choices.empty() || option.is_positional()) continue;
    for (const std::string& name : option.names)
      text += fmt::format("    '{} {}') words='{}' ;;\n", entry.name, name, fmt::join(option.choices, " "));
  }
  return text;
}

std::string bash_words(const Entry& entry) {
  std::vector<std::string> flags, values;
  for (const Option& option : entry.options) {
    std::vector<std::string>& list = option.is_positional() ? values : flags;
    const std::vector<std::string>& words = option.is_positional() ? option.choices : option.names;
    list.insert(list.end(), words.begin(), words.end());
  }
  return fmt::format("    '{}') if [[ $cur == -* ]]; then words='{} --help'; else words='{}'; fi ;;\n", entry.name,
                     fmt::join(flags, " "), fmt::join(values, " "));
}

std::string bash(const std::vector<Entry>& all) {
  std::string groups, values, words;
  for (const std::string& word : first_words(all)) {
    const std::vector<std::string> second = members(all, word);
    if (!second.empty()) groups += fmt::format("    {}) words='{}' ;;\n", word, fmt::join(second, " "));
  }
  for (const Entry& entry : all) values += bash_option_values(entry), words += bash_words(entry);
  return fmt::format(
      "# bash completion for plico; written by 'plico completions bash'\n"
      "_plico() {{\n"
      "  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD - 1]}} words=''\n"
      "  local command=${{COMP_WORDS[1]}}\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$cur\"))\n"
      "    return\n"
      "  fi\n"
      "  case $command in\n{}  esac\n"
      "  if [[ -n $words ]]; then\n"
      "    if ((COMP_CWORD == 2)); then\n"
      "      COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
      "      return\n"
      "    fi\n"
      "    command+=\" ${{COMP_WORDS[2]}}\"\n"
      "    words=''\n"
      "  fi\n"
      "  case \"$command $prev\" in\n{}  esac\n"
      "  if [[ -z $words ]]; then\n"
      "    case $command in\n{}    esac\n"
      "  fi\n"
      "  if [[ -n $words ]]; then COMPREPLY=($(compgen -W \"$words\" -- \"$cur\")); fi\n"
      "}}\n"
      "complete -o default -F _plico plico\n",
      fmt::join(first_words(all), " "), groups, values, words);
}

std::string zsh_option(const Option& option) {
  const std::string help = option.help;
  const bool path = option.value == "FILE" || option.value == "DIR" || option.value == "PATH";
  const std::string action =
      option.choices.empty() ? path ? "_files" : " " : fmt::format("({})", fmt::join(option.choices, " "));
  const std::string escaped = quoted("[" + help + "]", ":").substr(1);
  const std::string value = option.is_flag() ? "'" : fmt::format(":{}:{}'", option.value, action);
  const std::string tail = escaped.substr(0, escaped.size() - 1) + value;
  std::string text;
  for (const std::string& name : option.names)
    text += fmt::format("        '{}{}{} \\\n", option.repeatable ? "*" : "", name, tail);
  return text;
}

std::string zsh(const std::vector<Entry>& all) {
  std::string commands, cases;
  for (const std::string& word : first_words(all)) commands += " " + word;
  for (const std::string& word : first_words(all))
    if (const auto second = members(all, word); !second.empty())
      cases += fmt::format("    {}) if ((CURRENT == 3)); then compadd {}; return; fi; command+=\" $words[3]\" ;;\n",
                           word, fmt::join(second, " "));
  std::string options;
  for (const Entry& entry : all) {
    options += fmt::format("    '{}')\n      _arguments \\\n", entry.name);
    for (const Option& option : entry.options)
      if (!option.is_positional()) options += zsh_option(option);
    std::string positional = "_files";
    for (const Option& option : entry.options)
      if (option.is_positional() && !option.choices.empty())
        positional = fmt::format("({})", fmt::join(option.choices, " "));
    options += fmt::format("        '*:argument:{}' ;;\n", positional);
  }
  return fmt::format(
      "#compdef plico\n# zsh completion for plico; written by 'plico completions zsh'\n"
      "_plico() {{\n  local command=$words[2]\n"
      "  if ((CURRENT == 2)); then compadd --{} ; return; fi\n"
      "  case $command in\n{}  esac\n"
      "  case $command in\n{}  esac\n}}\n"
      "if [[ $funcstack[1] == _plico ]]; then _plico \"$@\"; else compdef _plico plico; fi\n",
      commands, cases, options);
}

std::string fish_option(const Entry& entry, const Option& option) {
  std::string text = fmt::format("complete -c plico -n {}", quoted(fmt::format("__plico_is {}", entry.name)));
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
  if (!option.is_flag())
    text += option.choices.empty() ? " -r" : fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
  return text + fmt::format(" -d {}\n", quoted(option.help, "\\"));
}

std::string fish(const std::vector<Entry>& all) {
  std::string text =
      "# fish completion for plico; written by 'plico completions fish'\n"
      "function __plico_is\n"
      "  set -l words (commandline -opc)\n"
      "  test (count $words) -gt (count $argv); or return 1\n"
      "  test \"$words[2..(math 1 + (count $argv))]\" = \"$argv\"\n"
      "end\n";
  for (const std::string& word : first_words(all))
    text += fmt::format("complete -c plico -n 'test (count (commandline -opc)) -eq 1' -f -a {}\n", word);
  for (const Entry& entry : all) {
    if (!entry.member.empty())
      text += fmt::format("complete -c plico -n '__plico_is {}' -f -a {} -d {}\n", entry.group, entry.member,
                          quoted(entry.summary, "\\"));
    for (const Option& option : entry.options) {
      if (!option.is_positional())
        text += fish_option(entry, option);
      else if (!option.choices.empty())
        text += fmt::format("complete -c plico -n '__plico_is {}' -f -a '{}'\n", entry.name,
                            fmt::join(option.choices, " "));
    }
  }
  return text;
}

int write_completions(const std::string& shell, Session& session) {
  jobs::SharedOptions shared;
  const std::vector<Entry> all = entries(all_commands(), shared);
  const std::string text = shell == "bash" ? bash(all) : shell == "zsh" ? zsh(all) : fish(all);
  for (const std::string& path : session.outputs("-")) session.write(path, text);
  return jobs::kDone;
}

}  // namespace

Job completions_command() {
  const auto shell = std::make_shared<std::string>();
  return Job("completions", "Write the completions of a shell")
      .example("source <(plico completions bash)", "in this shell, now")
      .example("plico completions zsh -o ~/.zfunc/_plico", "for zsh, kept")
      .example("plico completions fish -o ~/.config/fish/completions/plico.fish", "for fish, kept")
      .choice("shell", "which shell", *shell, {"bash", "zsh", "fish"})
      .action([shell](Session& session) { return write_completions(*shell, session); });
}

}  // namespace plico::cli
