#include "plico/workflow/jobs/face_orders.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plico/base/error.h"

namespace plico::jobs {
namespace {

constexpr const char* kFaceOrders = "faceOrders";

}  // namespace

std::vector<FaceOrder> face_orders(const FoldFile& file) {
  const auto found =
      std::find_if(file.other.begin(), file.other.end(), [](const auto& entry) { return entry.first == kFaceOrders; });
  std::vector<FaceOrder> orders;
  if (found == file.other.end()) return orders;
  const nlohmann::json list = nlohmann::json::parse(found->second);
  const int panels = file.net.sheet.num_faces();
  const auto is_panel = [&](const nlohmann::json& f) {
    return f.is_number_integer() && f.get<long>() >= 0 && f.get<long>() < panels;
  };
  for (const nlohmann::json& entry : list) {
    const bool fits = entry.is_array() && entry.size() == 3 && is_panel(entry[0]) && is_panel(entry[1]) &&
                      entry[2].is_number_integer() && (entry[2] == -1 || entry[2] == 0 || entry[2] == 1);
    if (!fits)
      throw InvalidInput("fold/face-orders",
                         fmt::format("faceOrders entry {} is not two of {} panels and -1, 0 or 1: {}", orders.size(),
                                     panels, entry.dump()));
    orders.push_back({entry[0].get<int>(), entry[1].get<int>(), entry[2].get<int>()});
  }
  return orders;
}

void set_face_orders(FoldFile& file, const std::vector<FaceOrder>& orders) {
  nlohmann::json list = nlohmann::json::array();
  for (const FaceOrder& order : orders) list.push_back({order.f, order.g, order.side});
  std::erase_if(file.other, [](const auto& entry) { return entry.first == kFaceOrders; });
  file.other.emplace_back(kFaceOrders, list.dump());
  std::sort(file.other.begin(), file.other.end());
}

}  // namespace plico::jobs
