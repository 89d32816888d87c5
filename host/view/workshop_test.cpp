// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/workshop.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <thread>

#include "host/error.h"

namespace dynrt::host {
namespace {

using Json = nlohmann::ordered_json;

Json ended(const Workshop& workshop) {
  while (workshop.progress()["state"] == "running") std::this_thread::yield();
  return workshop.progress();
}

TEST(Workshop, TellsHowFarAJobIsAndWhatItGave) {
  Workshop workshop;
  EXPECT_EQ(workshop.progress()["state"], "none");
  std::promise<void> told, go;
  const unsigned job = workshop.start("the job", [&](const Workshop::Tell& tell) -> Json {
    tell("half");
    told.set_value();
    go.get_future().wait();
    return 42;
  });
  told.get_future().wait();
  const Json half = workshop.progress();
  EXPECT_EQ(half["state"], "running");
  EXPECT_EQ(half["progress"], "half");
  EXPECT_EQ(half["job"], job);
  EXPECT_THROW(workshop.start("another", [](const Workshop::Tell&) { return Json(); }), UserError);
  go.set_value();
  const Json done = ended(workshop);
  EXPECT_EQ(done["state"], "done");
  EXPECT_EQ(done["result"], 42);
}

TEST(Workshop, SaysWhyAJobFailed) {
  Workshop workshop;
  const unsigned first = workshop.start(
      "the job", [](const Workshop::Tell&) -> Json { throw std::runtime_error("no wood"); });
  const Json failed = ended(workshop);
  EXPECT_EQ(failed["state"], "failed");
  EXPECT_EQ(failed["error"], "no wood");
  EXPECT_GT(workshop.start("the next", [](const Workshop::Tell&) { return Json(1); }), first);
  EXPECT_EQ(ended(workshop)["result"], 1);
}

}  // namespace
}  // namespace dynrt::host
