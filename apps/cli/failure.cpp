#include "failure.h"

#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "highlight.h"
#include "plico/base/error.h"

namespace plico::cli {
namespace {

using jobs::ExitCode;

Failure failure_of(const Error& error, ExitCode exit_code, const jobs::Attempt& attempt) {
  return {exit_code, error.code(), error.what(), error.where(), remedy(error, attempt)};
}

Failure bug(const std::exception& error) {
  return {jobs::kInternal, "internal/bug", error.what(), {}, "report this with the command line and the input"};
}

}  // namespace

Failure current_failure(const jobs::Attempt& attempt) {
  try {
    throw;
  } catch (const InvalidOption& error) {
    return failure_of(error, jobs::kUsage, attempt);
  } catch (const InvalidInput& error) {
    return failure_of(error, jobs::kBadInput, attempt);
  } catch (const FileError& error) {
    return failure_of(error, jobs::kFile, attempt);
  } catch (const std::bad_alloc&) {
    return {jobs::kMemory,
            "system/memory",
            "out of memory",
            {},
            "use a mesh with fewer faces, or a machine with more memory"};
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) return bug(error);
    return {jobs::kMemory,
            "system/threads",
            "the system gives no more threads",
            {},
            "close other programs, or add --threads 1"};
  } catch (const std::exception& error) {
    return bug(error);
  }
}

void tell(const Failure& failure, bool json) {
  const std::string code = highlighted(failure.code + ":", Highlight::Error);
  std::fprintf(stderr, "plico: %s %s\n", code.c_str(), failure.message.c_str());
  if (!failure.where.empty()) std::fprintf(stderr, "  where: %s\n", failure.where.c_str());
  if (!failure.suggestion.empty()) std::fprintf(stderr, "  try:   %s\n", failure.suggestion.c_str());
  if (!json) return;
  const nlohmann::json error = {{"code", failure.code},
                                {"message", failure.message},
                                {"where", failure.where},
                                {"suggestion", failure.suggestion}};
  std::puts(nlohmann::json({{"error", error}, {"exit_code", failure.exit_code}}).dump().c_str());
}

}  // namespace plico::cli
