#include "plico/io/page/dxf.h"

#include <fmt/format.h>

#include <iterator>

#include "plico/font/font.h"

namespace plico {
namespace {

bool is_line(const Pen& pen) { return !pen.fill && !pen.to_look_at; }

// AutoCAD's colour numbers by distance; enough for the pens of the styles.
int color_number(const std::array<double, 3>& color) {
  constexpr struct {
    int number;
    double r, g, b;
  } kColors[] = {{1, 1, 0, 0}, {2, 1, 1, 0}, {3, 0, 1, 0}, {4, 0, 1, 1},
                 {5, 0, 0, 1}, {6, 1, 0, 1}, {7, 0, 0, 0}, {8, 0.5, 0.5, 0.5}};
  int best = 7;
  double least = 10;
  for (const auto& c : kColors) {
    const double d = Vec3(c.r - color[0], c.g - color[1], c.b - color[2]).squaredNorm();
    if (d < least) least = d, best = c.number;
  }
  return best;
}

// Fixed handles of the objects that refer to each other; the others are counted from kFirstFree.
constexpr int kModelSpace = 0x1F, kPaperSpace = 0x1B, kRootDictionary = 0xC, kGroups = 0xD, kFirstFree = 0x100;

class DxfWriter {
 public:
  explicit DxfWriter(const Drawing& drawing) : drawing_(drawing) {}

  std::string run() {
    write_tables();
    write_blocks();
    write_entities();
    write_objects();
    group(0, "EOF");
    std::string body = std::move(text_);
    text_.clear();
    write_header();  // last, because it says which handle is free
    return text_ + body;
  }

 private:
  void group(int code, std::string_view value) { fmt::format_to(std::back_inserter(text_), "{:3}\n{}\n", code, value); }
  void number(int code, int value) { group(code, fmt::format("{}", value)); }
  void real(int code, double value) {
    const std::string text = decimal(value);
    group(code, text.find('.') == std::string::npos ? text + ".0" : text);
  }
  void handle(int code, int value) { group(code, fmt::format("{:X}", value)); }
  int new_handle() {
    handle(5, next_handle_);
    return next_handle_++;
  }
  void section(std::string_view section_name) {
    group(0, "SECTION");
    group(2, section_name);
  }

  void write_header() {
    section("HEADER");
    group(9, "$ACADVER");
    group(1, "AC1015");
    group(9, "$DWGCODEPAGE");
    group(3, "ANSI_1252");
    group(9, "$HANDSEED");
    handle(5, next_handle_);
    group(9, "$INSUNITS");
    number(70, 4);
    group(9, "$MEASUREMENT");
    number(70, 1);
    group(9, "$LTSCALE");
    real(40, 1);
    group(9, "$EXTMIN");
    point({0, 0});
    group(9, "$EXTMAX");
    point(drawing_.size);
    group(9, "$LIMMIN");
    point2({0, 0});
    group(9, "$LIMMAX");
    point2(drawing_.size);
    group(0, "ENDSEC");
  }

  void point2(const Vec2& p) {
    real(10, p.x());
    real(20, p.y());
  }
  void point(const Vec2& p) {
    point2(p);
    real(30, 0);
  }

  int begin_table(std::string_view table_name, int entries) {
    group(0, "TABLE");
    group(2, table_name);
    const int table = new_handle();
    handle(330, 0);
    group(100, "AcDbSymbolTable");
    number(70, entries);
    return table;
  }
  void begin_record(std::string_view type, std::string_view subclass, std::string_view record_name, int table,
                    int fixed_handle = 0) {
    group(0, type);
    if (fixed_handle)
      handle(type == "DIMSTYLE" ? 105 : 5, fixed_handle);
    else if (type == "DIMSTYLE")
      handle(105, next_handle_++);
    else
      new_handle();
    handle(330, table);
    group(100, "AcDbSymbolTableRecord");
    group(100, subclass);
    group(2, record_name);
  }
  void end_table() { group(0, "ENDTAB"); }

  void write_tables() {
    section("TABLES");
    write_viewport();
    write_linetypes();
    write_layers();
    write_text_style();
    for (const char* empty : {"VIEW", "UCS"}) {
      begin_table(empty, 0);
      end_table();
    }
    begin_record("APPID", "AcDbRegAppTableRecord", "ACAD", begin_table("APPID", 1));
    number(70, 0);
    end_table();
    const int dimstyles = begin_table("DIMSTYLE", 1);
    group(100, "AcDbDimStyleTable");
    begin_record("DIMSTYLE", "AcDbDimStyleTableRecord", "Standard", dimstyles);
    number(70, 0);
    end_table();
    const int blocks = begin_table("BLOCK_RECORD", 2);
    begin_record("BLOCK_RECORD", "AcDbBlockTableRecord", "*Model_Space", blocks, kModelSpace);
    begin_record("BLOCK_RECORD", "AcDbBlockTableRecord", "*Paper_Space", blocks, kPaperSpace);
    end_table();
    group(0, "ENDSEC");
  }

  void write_viewport() {
    begin_record("VPORT", "AcDbViewportTableRecord", "*ACTIVE", begin_table("VPORT", 1));
    number(70, 0);
    const struct {
      int code;
      Vec2 at;
    } points[] = {{10, {0, 0}}, {11, {1, 1}}, {12, drawing_.size / 2}, {13, {0, 0}}, {14, {10, 10}}, {15, {10, 10}}};
    for (const auto& [code, at] : points) {
      real(code, at.x());
      real(code + 10, at.y());
    }
    real(40, drawing_.size.y());
    real(41, drawing_.size.x() / drawing_.size.y());
    end_table();
  }

  void write_linetypes() {
    const int table = begin_table("LTYPE", 5);
    linetype(table, "ByBlock", "", {});
    linetype(table, "ByLayer", "", {});
    linetype(table, "Continuous", "Solid line", {});
    linetype(table, "MOUNTAIN", "Mountain __ . __ .", pen_of(Layer::Mountain).dash);
    linetype(table, "VALLEY", "Valley __ __ __", pen_of(Layer::Valley).dash);
    end_table();
  }

  void linetype(int table, std::string_view type_name, std::string_view text, const std::vector<double>& dash) {
    begin_record("LTYPE", "AcDbLinetypeTableRecord", type_name, table);
    number(70, 0);
    group(3, text);
    number(72, 65);
    number(73, static_cast<int>(dash.size()));
    double length = 0;
    for (double d : dash) length += d;
    real(40, length);
    for (std::size_t i = 0; i < dash.size(); ++i) {
      real(49, i % 2 ? -dash[i] : dash[i]);
      number(74, 0);
    }
  }

  // The pen that a layer is mostly drawn with.
  Pen pen_of(Layer layer) const {
    for (const Stroke& stroke : drawing_.strokes)
      if (stroke.layer == layer && is_line(drawing_.pens[stroke.pen])) return drawing_.pens[stroke.pen];
    if (layer == Layer::Text && !drawing_.texts.empty()) return drawing_.pens[drawing_.texts.front().pen];
    return {};
  }

  void write_layers() {
    const int table = begin_table("LAYER", 1 + static_cast<int>(kLayers.size()));
    layer_record(table, "0", 7, "Continuous");
    for (Layer layer : kLayers) {
      const Pen pen = pen_of(layer);
      const bool dashed = (layer == Layer::Mountain || layer == Layer::Valley) && !pen.dash.empty();
      layer_record(table, name(layer), color_number(pen.color), dashed ? name(layer) : "Continuous");
    }
    end_table();
  }

  void layer_record(int table, std::string_view layer_name, int color, std::string_view type) {
    begin_record("LAYER", "AcDbLayerTableRecord", layer_name, table);
    number(70, 0);
    number(62, color);
    group(6, type);
  }

  void write_text_style() {
    begin_record("STYLE", "AcDbTextStyleTableRecord", "Standard", begin_table("STYLE", 1));
    number(70, 0);
    real(40, 0);
    real(41, 1);
    real(50, 0);
    number(71, 0);
    real(42, 2.5);
    group(3, "txt");
    group(4, "");
    end_table();
  }

  void write_blocks() {
    section("BLOCKS");
    for (const auto& [block_name, record] :
         {std::pair("*Model_Space", kModelSpace), std::pair("*Paper_Space", kPaperSpace)}) {
      group(0, "BLOCK");
      new_handle();
      handle(330, record);
      group(100, "AcDbEntity");
      group(8, "0");
      group(100, "AcDbBlockBegin");
      group(2, block_name);
      number(70, 0);
      point({0, 0});
      group(3, block_name);
      group(1, "");
      group(0, "ENDBLK");
      new_handle();
      handle(330, record);
      group(100, "AcDbEntity");
      group(8, "0");
      group(100, "AcDbBlockEnd");
    }
    group(0, "ENDSEC");
  }

  // Machines work from top to bottom of the file: marks and scores before cuts.
  void write_entities() {
    section("ENTITIES");
    const Font font;
    for (const Text& text : drawing_.texts) {
      const Eigen::Matrix2d turn = rotation(text.angle);
      for (std::vector<Vec2> outline : font.outlines(text.text, text.size)) {
        for (Vec2& p : outline) p = text.start + turn * p;
        polyline(outline, true, Layer::Text);
      }
    }
    for (Layer layer : kDrawOrder)
      for (const Stroke& stroke : drawing_.strokes)
        if (stroke.layer == layer && is_line(drawing_.pens[stroke.pen])) polyline(stroke.points, stroke.closed, layer);
    group(0, "ENDSEC");
  }

  void polyline(const std::vector<Vec2>& points, bool closed, Layer layer) {
    group(0, "LWPOLYLINE");
    new_handle();
    handle(330, kModelSpace);
    group(100, "AcDbEntity");
    group(8, name(layer));
    group(100, "AcDbPolyline");
    number(90, static_cast<int>(points.size()));
    number(70, closed ? 1 : 0);
    for (const Vec2& p : points) point2(p);
  }

  void write_objects() {
    section("OBJECTS");
    group(0, "DICTIONARY");
    handle(5, kRootDictionary);
    handle(330, 0);
    group(100, "AcDbDictionary");
    number(281, 1);
    group(3, "ACAD_GROUP");
    handle(350, kGroups);
    group(0, "DICTIONARY");
    handle(5, kGroups);
    handle(330, kRootDictionary);
    group(100, "AcDbDictionary");
    number(281, 1);
    group(0, "ENDSEC");
  }

  const Drawing& drawing_;
  std::string text_;
  int next_handle_ = kFirstFree;
};

}  // namespace

std::string write_dxf(const Drawing& drawing) { return DxfWriter(drawing).run(); }

}  // namespace plico
