#include "plico/io/mesh/threemf.h"

#include <fmt/format.h>

#include "plico/base/error.h"
#include "plico/io/text/xml_text.h"
#include "plico/io/text/zip.h"
#include "plico/mesh/triangulate.h"

namespace plico {
namespace {

constexpr char kXml[] = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr char kModelPath[] = "3D/3dmodel.model";

std::string content_types() {
  return fmt::format(
      "{}<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
      "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
      "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
      "</Types>\n",
      kXml);
}

std::string relationships() {
  return fmt::format(
      "{}<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
      "<Relationship Target=\"/{}\" Id=\"rel0\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
      "</Relationships>\n",
      kXml, kModelPath);
}

void append_mesh(fmt::memory_buffer& out, const PolygonSoup& solid) {
  const auto add = fmt::appender(out);
  fmt::format_to(add, "<mesh>\n<vertices>\n");
  for (const Vec3& p : solid.points) fmt::format_to(add, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x(), p.y(), p.z());
  fmt::format_to(add, "</vertices>\n<triangles>\n");
  for (int f = 0; f < solid.num_faces(); ++f)
    for (const auto& [a, b, c] : triangulate_face(solid, f))
      fmt::format_to(add, "<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  fmt::format_to(add, "</triangles>\n</mesh>\n");
}

// Rows are multiplied from the left there: the columns of our matrix, then the shift.
std::string matrix(const Pose& pose) {
  std::string text;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) text += fmt::format("{}{}", text.empty() ? "" : " ", pose.matrix()(row, column));
  return text;
}

std::string model(const PlacedSolid& what) {
  fmt::memory_buffer out;
  const auto add = fmt::appender(out);
  const std::string name = xml_text(what.name);
  fmt::format_to(add,
                 "{}<model unit=\"millimeter\" xml:lang=\"en-US\" "
                 "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                 "<metadata name=\"Title\">{}</metadata>\n<resources>\n<object id=\"1\" type=\"model\" name=\"{}\">\n",
                 kXml, name, what.places.size() > 1 ? name + " panel" : name);
  append_mesh(out, what.solid);
  fmt::format_to(add, "</object>\n");
  const bool is_placed = what.places.size() > 1;
  if (is_placed) {
    fmt::format_to(add, "<object id=\"2\" type=\"model\" name=\"{}\">\n<components>\n", name);
    for (const Pose& place : what.places)
      fmt::format_to(add, "<component objectid=\"1\" transform=\"{}\"/>\n", matrix(place));
    fmt::format_to(add, "</components>\n</object>\n");
  }
  fmt::format_to(add, "</resources>\n<build>\n");
  if (is_placed)
    fmt::format_to(add, "<item objectid=\"2\"/>\n");
  else
    fmt::format_to(add, "<item objectid=\"1\" transform=\"{}\"/>\n", matrix(what.places.front()));
  fmt::format_to(add, "</build>\n</model>\n");
  return fmt::to_string(out);
}

}  // namespace

PolygonSoup copies_of(const PlacedSolid& what) {
  PolygonSoup soup;
  for (const Pose& place : what.places) {
    const int first = soup.num_points();
    for (const Vec3& point : what.solid.points) soup.points.push_back(place * point);
    for (int corner : what.solid.corners) soup.corners.push_back(first + corner);
    const int before = soup.offsets.back();
    for (std::size_t f = 1; f < what.solid.offsets.size(); ++f) soup.offsets.push_back(before + what.solid.offsets[f]);
  }
  return soup;
}

std::string write_3mf(const PlacedSolid& what) {
  if (what.solid.num_faces() == 0 || what.places.empty())
    throw InvalidInput("mesh/empty", "there is no solid to print");
  return write_zip(
      {{"[Content_Types].xml", content_types()}, {"_rels/.rels", relationships()}, {kModelPath, model(what)}});
}

}  // namespace plico
