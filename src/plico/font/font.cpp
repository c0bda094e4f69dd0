#include "plico/font/font.h"

#include <cairo.h>

namespace plico {
namespace {
constexpr double kEm = 1000;  // large, so that hinting and cairo's fixed point do not matter
}

struct Font::Face {
  // Without bounds: cairo leaves out letters that begin more than 10 em beside a surface, even of a path.
  cairo_surface_t* surface = cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr);
  cairo_t* context = cairo_create(surface);
  Face() {
    cairo_select_font_face(context, kFamily, CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, kEm);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
    cairo_set_tolerance(context, kEm / 150);
  }
  ~Face() {
    cairo_destroy(context);
    cairo_surface_destroy(surface);
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
};

Font::Font() : face_(std::make_unique<Face>()) {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

double Font::width(std::string_view text, double size) const {
  cairo_text_extents_t extents;
  cairo_text_extents(face_->context, std::string(text).c_str(), &extents);
  return extents.x_advance / kEm * size;
}

std::vector<std::vector<Vec2>> Font::outlines(std::string_view text, double size) const {
  cairo_new_path(face_->context);
  cairo_move_to(face_->context, 0, 0);
  cairo_text_path(face_->context, std::string(text).c_str());
  cairo_path_t* path = cairo_copy_path_flat(face_->context);
  std::vector<std::vector<Vec2>> outlines;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* item = &path->data[i];
    if (item->header.type == CAIRO_PATH_MOVE_TO) outlines.emplace_back();
    if (item->header.type == CAIRO_PATH_MOVE_TO || item->header.type == CAIRO_PATH_LINE_TO)
      outlines.back().emplace_back(item[1].point.x / kEm * size, -item[1].point.y / kEm * size);
  }
  cairo_path_destroy(path);
  cairo_new_path(face_->context);
  for (auto& outline : outlines)
    while (outline.size() > 1 && outline.front() == outline.back()) outline.pop_back();
  std::erase_if(outlines, [](const auto& outline) { return outline.size() < 3; });
  return outlines;
}

}  // namespace plico
