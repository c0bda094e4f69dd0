// The dissertation's crease patterns of few vertices ([Xi17] fig. 3.2), with goals that close exactly. Its figures give
// neither coordinates nor angles; counts of creases and vertices are those of its table 3.1 unless it says otherwise.
#pragma once
#include "plico/fold/crease_pattern.h"

namespace plico {

CreasePattern l();               // a strip of three squares without a real vertex: folds of 180 and 90 degrees
CreasePattern l2();              // two crossing lines, four creases: one folds by 180, then the other by 90 degrees
CreasePattern waterbomb_base();  // eight creases: axes valley 90, diagonals mountain 180 degrees
CreasePattern diamond();         // six creases, all folded by 180 degrees
CreasePattern box1();            // corner of a box, its fourth quarter tucked in: five creases (table 3.1 counts six)
CreasePattern box2();            // two such corners side by side: nine creases
CreasePattern fly1();            // the waterbomb base seen from behind: eight creases
CreasePattern fly2();            // the same with one corner tucked: eleven creases, two real vertices
CreasePattern sailboat();  // 32 creases, all folded by 180 degrees, 13 real vertices (table 3.1 counts 34 creases)

// Not of the dissertation:
CreasePattern plane();         // a paper plane's nose: five creases, one real vertex
CreasePattern square_twist();  // a square that turns by a right angle: flat-folds, but no rigid motion leads there
CreasePattern letter();        // folded in three, then bent across all layers: only one fold after the other gets there

}  // namespace plico
