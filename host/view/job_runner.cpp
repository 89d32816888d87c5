// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/job_runner.h"

#include <exception>
#include <thread>
#include <utility>

#include "host/error.h"

namespace dynrt::host {

using Json = nlohmann::ordered_json;

unsigned JobRunner::start(const std::string& name, Job job) {
  const std::lock_guard lock(mutex_);
  if (state_ == "running") refuse("{} is under way; wait until it is done", name_);
  name_ = name;
  state_ = "running";
  progress_ = error_ = "";
  result_ = Json();
  begin_ = Clock::now();
  // The program ends without waiting for it.
  std::thread([this, job = std::move(job)] { work(job); }).detach();
  return ++number_;
}

void JobRunner::work(const Job& job) {
  Json result;
  std::string error;
  try {
    result = job([this](const std::string& progress) {
      const std::lock_guard lock(mutex_);
      progress_ = progress;
    });
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  const std::lock_guard lock(mutex_);
  end_ = Clock::now();
  result_ = std::move(result);
  error_ = std::move(error);
  state_ = error_.empty() ? "done" : "failed";
}

Json JobRunner::progress() const {
  const std::lock_guard lock(mutex_);
  const auto until = state_ == "running" ? Clock::now() : end_;
  return {{"job", number_},
          {"name", name_},
          {"state", state_},
          {"progress", progress_},
          {"seconds", std::chrono::duration<double>(until - begin_).count()},
          {"result", result_},
          {"error", error_}};
}

}  // namespace dynrt::host
