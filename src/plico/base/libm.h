// The functions of <cmath> that IEEE 754 does not round for us, the same to the last bit on every processor: musl's.
// glibc's own depend on whether the processor multiplies and adds in one step, and a net follows from such a bit.
// sqrt, floor, fmod, remainder and the like are exact everywhere and stay std's.
#pragma once

namespace plico {

double sin(double radians);
double cos(double radians);
double tan(double radians);
double asin(double x);
double acos(double x);
double atan2(double y, double x);
double hypot(double x, double y);
double log(double x);
double pow(double base, double exponent);

}  // namespace plico
