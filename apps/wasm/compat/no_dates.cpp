// libc++'s streams can write dates in many languages, with 5 kB of JavaScript behind this function. Nothing here does.
#include <time.h>

extern "C" size_t strftime_l(char*, size_t, const char*, const struct tm*, locale_t) { return 0; }
