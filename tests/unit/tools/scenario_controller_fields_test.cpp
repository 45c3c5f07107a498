#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "tools/scenario/controller_fields.hpp"

namespace surefoot::scenario {
namespace {

TEST(NewControllerFields, HaveASwitchForEveryControllerAtItsOwnPlace) {
  stabilizer::StabilizerConfig config;
  std::vector<Field> table;
  append_new_controller_fields(table, config);
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    const std::string key = std::string("stabilizer.") + stabilizer::name(row.controller);
    const auto field = std::ranges::find(table, key, &Field::key);
    ASSERT_NE(field, table.end()) << key;
    *std::get<bool*>(field->target) = true;
    EXPECT_TRUE(config.is_on[static_cast<std::size_t>(row.controller)]) << key;
  }
}

TEST(NewControllerFields, TakeTheirOwnDefaultsAndStandOnlyOnce) {
  stabilizer::StabilizerConfig config;
  std::vector<Field> table;
  append_new_controller_fields(table, config);
  std::set<std::string> keys;
  for (const Field& field : table) {
    EXPECT_TRUE(keys.insert(field.key).second) << field.key;
    EXPECT_TRUE(field.key.starts_with("stabilizer.")) << field.key;
    if (const auto* const number = std::get_if<double*>(&field.target)) {
      EXPECT_TRUE(is_in_range(field, **number)) << field.key << ": " << range_text(field);
    }
  }
}

}  // namespace
}  // namespace surefoot::scenario
