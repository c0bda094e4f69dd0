#include "plico/workflow/jobs/remedy.h"

#include <gtest/gtest.h>

namespace plico::jobs {
namespace {

std::string tried(const char* code, const std::string& where = "", const std::string& input = "a.obj") {
  return remedy(InvalidInput(code, "it cannot be", where), {.job = "craft", .input = input});
}

TEST(Remedy, TheErrorsOwnSuggestionComesFirst) {
  EXPECT_EQ(remedy(InvalidInput("read/syntax", "no", "a.obj:3", "rename it"), {}), "rename it");
}

TEST(Remedy, ALineOfAFileIsShown) {
  EXPECT_EQ(tried("read/syntax", "a.obj:17"), "sed -n 17p a.obj");
  EXPECT_EQ(tried("read/index", "my bird.obj:17: face 3 (vertices 1 2 9)"), "sed -n 17p 'my bird.obj'");
  EXPECT_EQ(tried("fold/json", "a.fold:1:3044"), "sed -n 1p a.fold | cut -c 3004-3084");
  EXPECT_EQ(tried("fold/json", "a.fold:2:3"), "sed -n 2p a.fold | cut -c 1-43");
}

TEST(Remedy, AByteOfAFileIsShown) {
  EXPECT_EQ(tried("read/truncated", "a.stl: byte 80"), "od -A d -c -j 80 -N 64 a.stl");
}

TEST(Remedy, StandardInputHasNoLineToShow) {
  EXPECT_EQ(tried("read/syntax", "-:17", "-"), "export the file again, or as OBJ");
  EXPECT_EQ(tried("mesh/open", "", "-"), "plico check FILE --repair -o repaired.obj");
}

TEST(Remedy, AnEmptyFileHasNoLineToShow) {
  EXPECT_EQ(tried("read/empty", "a.obj"), "plico sample bird -o bird.obj, for a mesh to begin with");
}

TEST(Remedy, NamesTheInput) {
  EXPECT_EQ(tried("mesh/open", "", "my bird.obj"), "plico check 'my bird.obj' --repair -o repaired.obj");
  EXPECT_EQ(tried("usage/option"), "plico craft --help");
  EXPECT_EQ(remedy(InvalidOption("no"), {}), "plico --help");
}

TEST(Remedy, EveryFamilyThatAFileLeadsToHasOne) {
  for (const char* code :
       {"chain/file",    "cp/type",        "fabricate/no-edge", "file/read",     "file/too-large", "file/write",
        "fold/type",     "fold/limits",    "fold/no-mesh",      "gallery/empty", "inflate/volume", "mesh/index",
        "mesh/empty",    "motion/times",   "opx/type",          "ori/row",       "origami/degree", "pattern/empty",
        "pattern/size",  "picture/size",   "project/form",      "read/binary",   "read/gltf",      "read/xml",
        "segment/names", "shell/no-parts", "stack/pieces",      "svg/root",      "trj/frames",     "verify/no-net"})
    EXPECT_NE(tried(code), "") << code;
}

}  // namespace
}  // namespace plico::jobs
