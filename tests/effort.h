// Sanitizers look for faults of the code, not of its results, and run it twenty times slower: a tenth of the cases of a
// law is enough for them. The release build tries all.
#pragma once
#include <algorithm>

namespace plico {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
#else
constexpr bool kSanitized = false;
#endif

constexpr int num_cases(int cases) { return kSanitized ? std::max(1, cases / 10) : cases; }

}  // namespace plico
