#include "plico/motion/contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "linkage_samples.h"

namespace plico {
namespace {

constexpr double kFar = 1e9;  // units: every contact counts

std::vector<Contact> contacts_at(const Linkage& linkage, const Configuration& config, PanelPair pair,
                                 double reach = kFar) {
  return contacts(linkage, make_plates(linkage, 1e-3), config, {pair}, reach);
}

double nearest(const std::vector<Contact>& all) {
  double apart = kFar;
  for (const Contact& contact : all) apart = std::min(apart, contact.apart);
  return apart;
}

// Three squares, the outer ones at right angles to the middle one: 1 apart, face to face.
TEST(Contacts, PanelsFaceToFaceAreAsFarApartAsTheSquareBetween) {
  const Linkage linkage = make_linkage(square_strip({kPi / 2, kPi / 2}));
  const std::vector<Contact> all = contacts_at(linkage, goal(linkage), {0, 2});
  ASSERT_EQ(all.size(), 4U);  // one a corner
  for (const Contact& contact : all) EXPECT_NEAR(contact.apart, 1, 1e-9);
}

TEST(Contacts, FartherThanTheReachThereAreNone) {
  const Linkage linkage = make_linkage(square_strip({kPi / 2, kPi / 2}));
  EXPECT_TRUE(contacts_at(linkage, goal(linkage), {0, 2}, 0.5).empty());
}

TEST(Contacts, SlopeIsTheDerivativeOfTheDistance) {
  const Linkage linkage = make_linkage(square_strip({1.8, 1.4, 1.1, 0.3}));
  constexpr double kStep = 1e-6;
  for (const PanelPair pair : {PanelPair{0, 2}, PanelPair{1, 3}, PanelPair{0, 3}}) {
    const std::vector<Contact> all = contacts_at(linkage, goal(linkage), pair);
    ASSERT_FALSE(all.empty());
    const auto closest =
        std::min_element(all.begin(), all.end(), [](const Contact& a, const Contact& b) { return a.apart < b.apart; });
    for (int h = 0; h < linkage.num_hinges(); ++h) {
      Configuration turned = goal(linkage);
      turned[h] += kStep;
      EXPECT_NEAR(closest->slope[h], (nearest(contacts_at(linkage, turned, pair)) - closest->apart) / kStep, 1e-4)
          << "panels " << pair.a << ", " << pair.b << ", hinge " << h;
    }
  }
}

TEST(Contacts, HingesBeyondBothPanelsDoNotMatter) {
  const Linkage linkage = make_linkage(square_strip({1.8, 1.4, 1.1, 0.3}));
  for (const Contact& contact : contacts_at(linkage, goal(linkage), {0, 2})) {
    EXPECT_EQ(contact.slope[2], 0);
    EXPECT_EQ(contact.slope[3], 0);
  }
}

}  // namespace
}  // namespace plico
