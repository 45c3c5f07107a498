#include "sim_hw/world/trunk_mass.hpp"

#include <gtest/gtest.h>

namespace surefoot::sim_hw {
namespace {

PayloadConfig box(double mass_kg, PayloadInertia inertia) {
  PayloadConfig payload;
  payload.mass_kg = mass_kg;
  payload.inertia = inertia;
  return payload;
}

void expect_diagonal(const geometry::Vector3& actual, double xx, double yy, double zz, double tolerance) {
  EXPECT_NEAR(actual.x(), xx, tolerance);
  EXPECT_NEAR(actual.y(), yy, tolerance);
  EXPECT_NEAR(actual.z(), zz, tolerance);
}

// El-Kahlout 2003, I_b = (m_b/12) diag(W^2+H^2, L^2+H^2, L^2+W^2) for 50 kg, 0.2 x 0.4 x 0.5 m.
TEST(TrunkMass, IsTheThesisBoxWithoutALoad) {
  const TrunkMass trunk = unloaded_trunk({});
  EXPECT_DOUBLE_EQ(trunk.mass_kg, 50.0);
  expect_diagonal(trunk.inertia_kg_m2, 50.0 / 12.0 * 0.41, 50.0 / 12.0 * 0.29, 50.0 / 12.0 * 0.20, 1e-12);
  expect_diagonal(trunk.com_body_m, -0.05, 0.0, 0.25, 0.0);
}

// Eq. (3.9): -0.02727, -0.00833, +0.00769 m. With the new m_b instead of the old it would differ.
TEST(TrunkMass, MovesItsCentreOfMassAsTheThesisSays) {
  const auto com_x = [](double mass_kg) {
    return hang_payload(unloaded_trunk({}), box(mass_kg, PayloadInertia::kThesis)).com_body_m.x();
  };
  EXPECT_NEAR(com_x(5.0), -1.5 / 55.0, 1e-15);
  EXPECT_NEAR(com_x(10.0), -0.5 / 60.0, 1e-15);
  EXPECT_NEAR(com_x(15.0), 0.5 / 65.0, 1e-15);
}

// Eq. (3.8): inertia scales with the mass.
TEST(TrunkMass, ScalesItsInertiaWithTheMassInTheThesisVariant) {
  const TrunkMass trunk = hang_payload(unloaded_trunk({}), box(15.0, PayloadInertia::kThesis));
  EXPECT_DOUBLE_EQ(trunk.mass_kg, 65.0);
  expect_diagonal(trunk.inertia_kg_m2, 2.221, 1.571, 1.083, 5e-4);
}

// Trunk and 0.2 m cube about their common centre of mass, 0.25 m apart along x:
// I_b + m a^2/6 + (m_b m/(m_b+m)) 0.25^2 about y and z.
TEST(TrunkMass, KeepsTheTrueInertiaInTheExactVariant) {
  const TrunkMass trunk = hang_payload(unloaded_trunk({}), box(15.0, PayloadInertia::kExact));
  expect_diagonal(trunk.inertia_kg_m2, 1.808, 2.029, 1.654, 5e-4);
  const double steiner = 50.0 * 15.0 / 65.0 * 0.0625;
  expect_diagonal(trunk.inertia_kg_m2, 50.0 / 12.0 * 0.41 + 0.1, 50.0 / 12.0 * 0.29 + 0.1 + steiner,
                  50.0 / 12.0 * 0.20 + 0.1 + steiner, 1e-12);
}

TEST(TrunkMass, DoesNotCareAboutTheOrderOfTwoBoxes) {
  PayloadConfig left = box(4.0, PayloadInertia::kExact);
  left.position_m = {0.1, 0.2, 0.1};
  const PayloadConfig front = box(7.0, PayloadInertia::kExact);
  const TrunkMass one = hang_payload(hang_payload(unloaded_trunk({}), left), front);
  const TrunkMass other = hang_payload(hang_payload(unloaded_trunk({}), front), left);
  EXPECT_TRUE(one.com_body_m.isApprox(other.com_body_m, 1e-14));
  EXPECT_TRUE(one.inertia_kg_m2.isApprox(other.inertia_kg_m2, 1e-14));
  EXPECT_NEAR(one.com_body_m.y(), 4.0 * 0.2 / 61.0, 1e-15);
  EXPECT_NEAR(one.com_body_m.z(), (54.0 * 0.25 - 4.0 * 0.0 + 4.0 * 0.1 + 3.0 * 0.25) / 61.0, 1e-15);
}

TEST(TrunkMass, StaysAsItIsUnderABoxWithoutMass) {
  for (const PayloadInertia inertia : {PayloadInertia::kThesis, PayloadInertia::kExact}) {
    const TrunkMass trunk = hang_payload(unloaded_trunk({}), box(0.0, inertia));
    EXPECT_TRUE(trunk.com_body_m.isApprox(unloaded_trunk({}).com_body_m, 1e-15));
    EXPECT_TRUE(trunk.inertia_kg_m2.isApprox(unloaded_trunk({}).inertia_kg_m2, 1e-15));
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
