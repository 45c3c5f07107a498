#pragma once

#include <vector>

#include "firmware/core/stabilizer/stabilizer.hpp"
#include "tools/scenario/field.hpp"

namespace surefoot::scenario {

/// Keys of [stabilizer]: the switches of all controllers, and the parameters of the six new ones of Kim, Park, Oh 2007.
void append_new_controller_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& config);

/// Keys of [stabilizer]: the parameters of the seven earlier controllers and of our three.
void append_old_controller_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& config);

/// Keys of [stabilizer]: what smooths the controllers' outputs, and their last constants.
void append_smoothing_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& config);

}  // namespace surefoot::scenario
