// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Runs long jobs in the background, one at a time: builds a configuration, renders a frame through
// the RTL. The server's threads start a job and ask how far it is.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace dynrt::host {

class JobRunner {
 public:
  /// Called by a job to say how far it is.
  using Tell = std::function<void(const std::string& progress)>;
  /// Returns its result.
  using Job = std::function<nlohmann::ordered_json(const Tell& tell)>;

  /// Returns the number of the job. Throws UserError while another job runs.
  unsigned start(const std::string& name, Job job);

  /// {"job", "name", "state": "none", "running", "done" or "failed", "progress", "seconds",
  /// "result", "error"}, of the last job.
  nlohmann::ordered_json progress() const;

 private:
  using Clock = std::chrono::steady_clock;

  void work(const Job& job);

  mutable std::mutex mutex_;
  unsigned number_ = 0;
  std::string name_, state_ = "none", progress_, error_;
  nlohmann::ordered_json result_;
  Clock::time_point begin_, end_;
};

}  // namespace dynrt::host
