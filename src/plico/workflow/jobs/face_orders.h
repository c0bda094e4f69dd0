// FOLD's faceOrders, which our files carry as a key of its own.
#pragma once
#include <vector>

#include "plico/fold/face_order.h"
#include "plico/io/pattern/fold.h"

namespace plico::jobs {

// Of the key frame; empty when it has none. Throws InvalidInput "fold/face-orders" with the entry at fault.
std::vector<FaceOrder> face_orders(const FoldFile& file);

// In the place of those that are there.
void set_face_orders(FoldFile& file, const std::vector<FaceOrder>& orders);

}  // namespace plico::jobs
