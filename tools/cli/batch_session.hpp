#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/run/exit_code.hpp"

namespace surefoot::cli {

/// What all commands that run many experiments are told alike.
struct BatchArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string plant;
  unsigned jobs = 0;
  bool is_fresh = false;
  bool is_csv = false;
  bool is_json = false;
  std::string png;
};

/// Adds --scenario, --set, --plant, --jobs, --fresh, --csv, --json and --png.
void add_batch_options(CLI::App& command, BatchArguments& arguments);

/// Arguments that contradict each other or hold no number; the message says which.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A batch run from the command line: progress on a terminal, Ctrl-C, and a journal in the user's cache, so that the
/// same command goes on where it was interrupted.
class BatchSession {
 public:
  /// @param name  of the command, for the journal and for messages
  BatchSession(std::string name, const BatchArguments& arguments);

  /// @throws as batch::run_batch
  [[nodiscard]] std::vector<run::Verdict> run(const batch::Batch& batch);

  /// The results are printed: the journal goes.
  void forget() noexcept;

 private:
  std::string name_;
  const BatchArguments& arguments_;
  std::filesystem::path journal_;
};

/// What a command prints, in the form that was asked for, and the picture of its JSON.
struct Output {
  std::function<std::string()> text;
  std::function<std::string()> csv;
  std::function<std::string()> json;
};

/// Prints to standard output and draws the picture where one was asked for.
/// @throws run::RecordingFailure when the picture cannot be drawn
void deliver(const Output& output, const BatchArguments& arguments);

/// Does `work` and turns its errors, an interruption among them, into a message and an exit code.
[[nodiscard]] run::ExitCode with_batch_messages(const std::string& name, const std::function<run::ExitCode()>& work);

}  // namespace surefoot::cli
