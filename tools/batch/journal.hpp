#pragma once

#include <filesystem>
#include <string>

#include "tools/batch/finished_trials.hpp"

namespace surefoot::batch {

/// Keeps the finished trials of a batch: a file that only grows, a line of JSON a trial, written at once when the
/// trial ends, so that a killed batch loses no finished one. A last line that was cut off is dropped.
///
/// The first line names the build that ran the trials; every other one the scenario: a changed program or a
/// changed batch is noticed. One process at a time may have it open.
class Journal {
 public:
  /// Opens or begins a journal, and gives `finished` what it holds.
  ///
  /// @throws scenario::ScenarioError when it belongs to another batch, another build or another process,
  ///         run::RecordingFailure when it cannot be opened or written
  Journal(std::filesystem::path file, FinishedTrials& finished);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// @param line  of `line_of`
  /// @throws run::RecordingFailure; what was kept before stays valid
  void append(const std::string& line);

  /// Takes over what another journal of the same batch holds and this one does not.
  /// @throws as the constructor
  void merge(const std::filesystem::path& part, FinishedTrials& finished);

 private:
  void begin(FinishedTrials& finished);
  void write(const std::string& text);

  std::filesystem::path file_;
  int descriptor_;
};

/// What a journal of this program begins with: the first line, without line break.
[[nodiscard]] const std::string& journal_header();

/// @throws scenario::ScenarioError unless `line` is that of this program
void check_journal_header(const std::string& place, const std::string& line);

}  // namespace surefoot::batch
