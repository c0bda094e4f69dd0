#include "plico/io/text/deflate.h"

#include <zlib.h>

#include <new>

namespace plico {

std::string zlib_stream(std::string_view bytes, int effort) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(result.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), effort);
  if (status != Z_OK) throw std::bad_alloc();  // the only failure left for a buffer of the right size
  result.resize(size);
  return result;
}

}  // namespace plico
