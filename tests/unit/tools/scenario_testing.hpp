#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

/// What a text's refusal says; empty when it is accepted.
inline std::string refusal_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)load_text("walk.toml", text, overrides);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return {};
}

/// A bad text as a failing test names it.
inline std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// The scenarios that ship with the project.
inline std::filesystem::path scenario_folder() {
  return SUREFOOT_SCENARIO_FOLDER;  // __FILE__ may be relative, as with a base_dir of ccache
}

/// A file that belongs to the running test alone.
inline std::filesystem::path write_file(const std::string& text) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / (std::string(test.test_suite_name()) + test.name() + ".toml");
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace surefoot::scenario
