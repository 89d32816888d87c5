// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Work beside the rendering: making a configuration, rendering a frame through the RTL. One job at
// a time, in a thread of its own; threads of the server start it and ask how far it is.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace dynrt::host {

class Workshop {
 public:
  /// Tells how far a job is, in words.
  using Tell = std::function<void(const std::string& progress)>;
  /// Gives the job's result.
  using Job = std::function<nlohmann::ordered_json(const Tell& tell)>;

  /// Gives the number of the job. Throws UserError while another one is done.
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
