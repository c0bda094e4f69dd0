// How good a net is for hands, measured on the net alone: whoever searched it is not asked.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "plico/fold/unfolding.h"

namespace plico {

struct HandMeasures {
  double net_area = 0, hull_area = 0;  // of all parts and of their convex hulls, square millimetres
  double fullest = 0, emptiest = 1;    // area over hull area of the best and the worst part
  // Of folds that carry a branch of more than kLightBranchPanels panels, that is, cut the part into two larger pieces.
  double shortest_carrying = 0;  // millimetres, 0 when there is none
  int weak = 0;                  // shorter than kShortestFold
  int least_weak = 0;            // no net of these parts of the shape has fewer at this scale, whatever its folds
  int needles = 0;  // panels longer than 3 times their shortest side with no fold of half their longest joinable side
  int tight_seams =
      0;  // edges that end in a notch of the outline under kTightest and are long enough to be glued there

  double left_over() const { return hull_area - net_area; }
};

inline constexpr int kLightBranchPanels = 3;
inline constexpr double kShortestFold = 5;        // millimetres
inline constexpr double kTightest = radians(20);  // no finger or blade gets in
inline constexpr double kLongEnough = 5;          // millimetres

// `scale` in millimetres per unit of the net. Folds that close loops of panels, as in origami, carry nothing. O(n log
// n) for panels with few sides.
HandMeasures measure_for_hands(const Unfolding& net, double scale);

// Folds to cut, by edge of the net, so that none that is left is weak. O(n).
std::vector<char> weak_folds(const Unfolding& net, double scale);
nlohmann::json json_of(const HandMeasures& measures);

}  // namespace plico
