#include "parse.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "plico/base/error.h"
#include "plico/workflow/jobs/suggest.h"

namespace plico::cli {
namespace {

using jobs::did_you_mean;
using jobs::nearest_word;

std::string help_of(const Job& job) { return fmt::format("plico {} --help", job.name); }

// CLI11 only takes the words apart; values are checked and set by the table, whose messages name values and bounds.
CLI::Option* declare(CLI::App& app, const Option& option) {
  std::string names = option.names.front();
  for (std::size_t i = 1; i < option.names.size(); ++i) names += "," + option.names[i];
  if (option.is_flag()) return app.add_flag(names)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* declared = app.add_option(names)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  if (option.is_positional()) return declared->expected(option.repeatable ? -1 : 1);
  return declared->expected(1)->allow_extra_args(false);
}

[[noreturn]] void refuse_unknown(const Job& job, const std::vector<Option>& table, const std::string& word) {
  if (!word.starts_with('-')) throw InvalidOption(fmt::format("unexpected argument '{}'", word), help_of(job));
  std::vector<std::string> known;
  for (const Option& option : table)
    if (!option.is_positional()) known.insert(known.end(), option.names.begin(), option.names.end());
  const std::string name = word.substr(0, word.find('='));
  const std::string nearest = name.size() > 2 ? nearest_word(name, known) : "";
  throw InvalidOption(fmt::format("unknown option '{}'{}", name, did_you_mean(nearest)), help_of(job));
}

void take_apart(CLI::App& app, std::vector<std::string> words) {
  std::ranges::reverse(words);  // CLI11's order
  try {
    app.parse(std::move(words));
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();
    throw InvalidOption(fmt::format("{} needs a value", message.substr(0, message.find(':'))));
  } catch (const CLI::ParseError& error) {
    throw InvalidOption(error.what());
  }
}

}  // namespace

std::vector<Given> parse(const Job& job, const std::vector<Option>& table, const std::vector<std::string>& words) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  std::vector<CLI::Option*> declared;
  for (const Option& option : table) declared.push_back(declare(app, option));
  take_apart(app, words);
  for (const std::string& word : app.remaining())
    if (word != "--") refuse_unknown(job, table, word);

  std::vector<Given> wanted;
  for (std::size_t i = 0; i < table.size(); ++i)
    for (const std::string& value : declared[i]->results()) wanted.push_back({&table[i], value});
  return set_options(job, table, wanted);
}

}  // namespace plico::cli
