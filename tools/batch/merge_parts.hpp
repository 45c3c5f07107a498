#pragma once

#include <filesystem>

#include "tools/batch/batch.hpp"

namespace surefoot::batch {

/// Takes the trials that other processes ran into the journal of a batch.
///
/// @param folder  all its files *.jsonl are journals of parts of the batch
/// @throws scenario::ScenarioError for a part of another batch or build, or when there is no part;
///         run::RecordingFailure when something cannot be read or written
void merge_parts(const Batch& batch, const std::filesystem::path& journal, const std::filesystem::path& folder);

}  // namespace surefoot::batch
