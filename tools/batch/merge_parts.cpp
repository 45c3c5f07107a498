#include "tools/batch/merge_parts.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "tools/batch/finished_trials.hpp"
#include "tools/batch/journal.hpp"
#include "tools/batch/load_trial.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::batch {

void merge_parts(const Batch& batch, const std::filesystem::path& journal, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> parts;
  std::error_code error;
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".jsonl") parts.push_back(entry.path());
  }
  if (parts.empty()) {
    throw scenario::ScenarioError({{folder.string(), "holds no part of a sweep (*.jsonl)",
                                    "name the folder that the job array wrote its parts into"}});
  }
  std::ranges::sort(parts);
  FinishedTrials finished(check_trials(batch, all_trials(batch.trials.size()), 0));
  Journal into(journal, finished);
  for (const std::filesystem::path& part : parts) into.merge(part, finished);
}

}  // namespace surefoot::batch
