// What nearly every test includes, compiled once for all of them: half of the time a test takes to compile goes into
// it.
#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "plico/base/vec.h"
#include "plico/fold/crease_pattern.h"
#include "plico/mesh/mesh.h"
