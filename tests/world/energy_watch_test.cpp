#include "ritz/world/energy_watch.hpp"

#include <gtest/gtest.h>

namespace ritz::world {
namespace {

TEST(EnergyWatch, ComparesTheEnergyWithTheWork) {
  EnergyWatch watch(0);
  watch.add(2, 0);
  watch.look(1, 2.15);
  EXPECT_FALSE(watch.gain());
  watch.add(0, 1);
  watch.look(2, 1.15);
  EXPECT_FALSE(watch.gain());
  watch.look(3, 1.5);
  ASSERT_TRUE(watch.gain());
  EXPECT_EQ(watch.gain()->since, 3);
  EXPECT_DOUBLE_EQ(watch.gain()->largest, .25);
}

TEST(EnergyWatch, KeepsTheBalance) {
  EnergyWatch watch(3);
  watch.add(2, .5);
  watch.look(1, 5);
  watch.look(2, 4.25);
  const auto balance = watch.balance();
  EXPECT_EQ(balance.start, 3);
  EXPECT_EQ(balance.gained, .5);
  EXPECT_EQ(balance.lost, .25);
  EXPECT_EQ(balance.available, 4.5);
  EXPECT_EQ(balance.largest_drift, .5);
  EXPECT_EQ(balance.work, 2);
  EXPECT_EQ(balance.dissipated, .5);
}

TEST(EnergyWatch, OfNoEnergyWarnsOfNothing) {
  EnergyWatch watch(0);
  watch.look(1, 0);
  EXPECT_FALSE(watch.gain());
}

}  // namespace
}  // namespace ritz::world
