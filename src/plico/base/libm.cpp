#include "plico/base/libm.h"

// Made by cmake/libm.cmake.
extern "C" {
double plico_musl_sin(double);
double plico_musl_cos(double);
double plico_musl_tan(double);
double plico_musl_asin(double);
double plico_musl_acos(double);
double plico_musl_atan2(double, double);
double plico_musl_hypot(double, double);
double plico_musl_log(double);
double plico_musl_pow(double, double);
}

namespace plico {

double sin(double radians) { return plico_musl_sin(radians); }
double cos(double radians) { return plico_musl_cos(radians); }
double tan(double radians) { return plico_musl_tan(radians); }
double asin(double x) { return plico_musl_asin(x); }
double acos(double x) { return plico_musl_acos(x); }
double atan2(double y, double x) { return plico_musl_atan2(y, x); }
double hypot(double x, double y) { return plico_musl_hypot(x, y); }
double log(double x) { return plico_musl_log(x); }
double pow(double base, double exponent) { return plico_musl_pow(base, exponent); }

}  // namespace plico
