// base/libm.h wants musl's functions under names of their own; emscripten's C library is musl.
#include <cmath>

extern "C" {
double plico_musl_sin(double x) { return std::sin(x); }
double plico_musl_cos(double x) { return std::cos(x); }
double plico_musl_tan(double x) { return std::tan(x); }
double plico_musl_asin(double x) { return std::asin(x); }
double plico_musl_acos(double x) { return std::acos(x); }
double plico_musl_atan2(double y, double x) { return std::atan2(y, x); }
double plico_musl_hypot(double x, double y) { return std::hypot(x, y); }
double plico_musl_log(double x) { return std::log(x); }
double plico_musl_pow(double base, double exponent) { return std::pow(base, exponent); }
}
