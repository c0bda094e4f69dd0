// What somebody probably meant.
#pragma once
#include <string>
#include <vector>

namespace plico::jobs {

// The known word nearest to `word` by edit distance (insert, delete, replace, swap neighbours); empty when all are too
// different to be what was meant, that is more than a third of its letters away. Ties go to the first.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

// ", did you mean 'seed'?" or nothing when `nearest` is empty: the end of a message.
std::string did_you_mean(const std::string& nearest);

}  // namespace plico::jobs
