#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "sim_hw/config_check.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct BadConfig {
  const char* field;
  std::function<void(SimConfig&)> spoil;
};

void PrintTo(const BadConfig& bad, std::ostream* stream) { *stream << bad.field; }

class RefusedPlant : public testing::TestWithParam<BadConfig> {};

TEST_P(RefusedPlant, NamesTheFieldAndTheRemedy) {
  SimConfig config;
  ASSERT_NO_THROW(check(config));
  GetParam().spoil(config);
  try {
    check(config);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    EXPECT_THAT(message, testing::StartsWith(std::string(GetParam().field) + " is "));
    EXPECT_THAT(message, testing::HasSubstr("; expected "));
    EXPECT_THAT(message, testing::HasSubstr("\n  remedy: "));
  }
}

PatchConfig& patch(SimConfig& config) { return config.terrain.patches.emplace_back(); }

INSTANTIATE_TEST_SUITE_P(
    Table, RefusedPlant,
    testing::Values(
        BadConfig{"floor.tile_height_m", [](SimConfig& c) { c.terrain.tile_height_m = -0.001; }},
        BadConfig{"floor.tile_height_m", [](SimConfig& c) { c.terrain.tile_height_m = 0.06; }},
        BadConfig{"floor.tile_height_m", [](SimConfig& c) { c.terrain.tile_height_m = kNan; }},
        BadConfig{"floor.tile_edge_m", [](SimConfig& c) { c.terrain.tile_edge_m = 0.0; }},
        BadConfig{"floor.tile_edge_m", [](SimConfig& c) { c.terrain.tile_edge_m = kNan; }},
        BadConfig{"floor.plates_per_m2", [](SimConfig& c) { c.terrain.plates_per_m2 = -1.0; }},
        BadConfig{"floor.plates_per_m2", [](SimConfig& c) { c.terrain.plates_per_m2 = 70.0; }},
        BadConfig{"floor.plate_height_m", [](SimConfig& c) { c.terrain.plate_height_m = -0.004; }},
        BadConfig{"floor.plate_edge_m", [](SimConfig& c) { c.terrain.plate_edge_m = 2.0; }},
        BadConfig{"patch count", [](SimConfig& c) { c.terrain.patches.resize(kMaxPatches + 1); }},
        BadConfig{"patch.centre_m", [](SimConfig& c) { patch(c).centre_m[1] = kNan; }},
        BadConfig{"patch.size_m", [](SimConfig& c) { patch(c).size_m[0] = 0.0; }},
        BadConfig{"patch.height_m", [](SimConfig& c) { patch(c).height_m = -0.01; }},
        BadConfig{"patch.friction", [](SimConfig& c) { patch(c).friction = kNan; }},
        BadConfig{"drive.rotor_share", [](SimConfig& c) { c.drive.rotor_share[3] = -1.0; }},
        BadConfig{"drive.servo_stiffness_nm_per_rad",
                  [](SimConfig& c) { c.drive.servo_stiffness_nm_per_rad[0] = kNan; }},
        BadConfig{"drive.servo_damping_nm_s_per_rad", [](SimConfig& c) { c.drive.servo_damping_nm_s_per_rad[5] = -1; }},
        BadConfig{"drive.hip_roll_stiffness_nm_per_rad",
                  [](SimConfig& c) { c.drive.hip_roll_stiffness_nm_per_rad = -1.0; }},
        BadConfig{"drive.hip_roll_stiffness_nm_per_rad",
                  [](SimConfig& c) {
                    c.drive.hip_roll_stiffness_nm_per_rad = 1500.0;
                    c.drive.rotor_share[1] = 0.0;
                  }},
        BadConfig{"drive.hip_roll_stiffness_nm_per_rad",
                  [](SimConfig& c) { c.drive.hip_roll_stiffness_nm_per_rad = 1.7e6; }},  // J / step^2 = 1.6e6
        BadConfig{"drive.hip_roll_damping_nm_s_per_rad",
                  [](SimConfig& c) { c.drive.hip_roll_damping_nm_s_per_rad = kNan; }},
        BadConfig{"sensor.hip_gyro_range_rad_s", [](SimConfig& c) { c.sensor.hip_gyro_range_rad_s = 0.0; }},
        BadConfig{"sensor.inclinometer_range_rad", [](SimConfig& c) { c.sensor.inclinometer_range_rad = kNan; }},
        BadConfig{"sensor.foot_accelerometer_range_m_s2",
                  [](SimConfig& c) { c.sensor.foot_accelerometer_range_m_s2 = -1.0; }}));

}  // namespace
}  // namespace surefoot::sim_hw
