// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/job_runner.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

#include "host/error.h"

namespace dynrt::host {
namespace {

using Json = nlohmann::ordered_json;

Json ended(const JobRunner& runner) {
  while (runner.progress()["state"] == "running") std::this_thread::yield();
  return runner.progress();
}

TEST(JobRunner, TellsHowFarAJobIsAndWhatItGave) {
  JobRunner runner;
  EXPECT_EQ(runner.progress()["state"], "none");
  std::promise<void> told, go;
  const unsigned job = runner.start("the job", [&](const JobRunner::Tell& tell) -> Json {
    tell("half");
    told.set_value();
    go.get_future().wait();
    return 42;
  });
  told.get_future().wait();
  const Json half = runner.progress();
  EXPECT_EQ(half["state"], "running");
  EXPECT_EQ(half["progress"], "half");
  EXPECT_EQ(half["job"], job);
  EXPECT_THROW(runner.start("another", [](const JobRunner::Tell&) { return Json(); }), UserError);
  go.set_value();
  const Json done = ended(runner);
  EXPECT_EQ(done["state"], "done");
  EXPECT_EQ(done["result"], 42);
}

TEST(JobRunner, SaysWhyAJobFailed) {
  JobRunner runner;
  const unsigned first = runner.start(
      "the job", [](const JobRunner::Tell&) -> Json { throw std::runtime_error("no disk"); });
  const Json failed = ended(runner);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["error"], "no disk");
  EXPECT_GT(runner.start("the next", [](const JobRunner::Tell&) { return Json(1); }), first);
  EXPECT_EQ(ended(runner)["result"], 1);
}

}  // namespace
}  // namespace dynrt::host
