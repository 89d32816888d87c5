// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/analysis/stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>

namespace dynrt::host::stress {

namespace {

using Json = nlohmann::ordered_json;

std::string hex(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

std::uint64_t sum(std::span<const Result> results, std::uint64_t Outcome::* of) {
  std::uint64_t all = 0;
  for (const Result& r : results) all += r.outcome.*of;
  return all;
}

std::string verdict_of(const Result& r) {
  if (r.outcome.exceeds_core) return "refused";
  if (!r.within()) return "EXCEEDS";
  return r.allowed.stated ? "ok" : "no bound";
}

}  // namespace

Result run_case(const Case& c, Boards& boards, std::vector<Frame>* frames) {
  const auto begin = std::chrono::steady_clock::now();
  Examiner examiner(boards, frames);
  try {
    c.run(examiner);
  } catch (const BoardError&) {
    throw;
  } catch (const Exceeded& error) {
    examiner.exceeded(error.what());
  } catch (const UserError& error) {
    examiner.refused(error.what());
  }
  Result result{&c, examiner.outcome(), c.allowed(boards.get().core()),
                c.why_on(boards.get().core())};
  result.outcome.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

std::string line_of(const Result& r) {
  const Outcome& o = r.outcome;
  const std::string what =
      o.refusal.empty() ? fmt::format("{} rays, {} hit; {}", o.rays, o.hits, text_of(o, r.allowed))
                        : fmt::format("{} rays, refused: {}", o.rays, o.refusal);
  return fmt::format("{:<10}{:<36}{}: {}", verdict_of(r), r.stress->full_name(), r.stress->about,
                     what);
}

std::string summary_of(std::span<const Result> results, double seconds) {
  const auto exceeding =
      std::ranges::count_if(results, [](const Result& r) { return !r.within(); });
  const auto unbound =
      std::ranges::count_if(results, [](const Result& r) { return !r.allowed.stated; });
  const auto refused =
      std::ranges::count_if(results, [](const Result& r) { return r.outcome.exceeds_core; });
  return fmt::format(
      "{} cases, {} rays, {} hit; {} exceed what is allowed{}{}; {:.1f} s; digest {}",
      results.size(), sum(results, &Outcome::rays), sum(results, &Outcome::hits),
      exceeding == 0 ? "none" : fmt::format("{}", exceeding),
      unbound == 0
          ? ""
          : fmt::format(", {} have no bound for lost, invented and wrong rays on this core",
                        unbound),
      refused == 0 ? ""
                   : fmt::format(", {} refused, as the core was made for smaller scenes", refused),
      seconds, hex(digest_of(results)));
}

Json json_of(std::span<const Result> results, const std::string& configuration,
             const std::string& board, double seconds) {
  Json cases = Json::array();
  for (const Result& r : results) {
    Json faults = Json::object();
    Json allowed = Json::object();
    for (std::size_t i = 0; i < kFaults; ++i) {
      faults[fault_texts()[i].name] = r.outcome.faults[i];
      const auto bound = r.allowed.count(static_cast<Fault>(i));
      allowed[fault_texts()[i].name] = bound ? Json(*bound) : Json();
    }
    faults["distance"] = r.outcome.distance;
    allowed["distance"] = r.allowed.stated ? Json(r.allowed.distance) : Json();
    cases.push_back({{"name", r.stress->full_name()},
                     {"about", r.stress->about},
                     {"rays", r.outcome.rays},
                     {"hits", r.outcome.hits},
                     {"wrong", faults},
                     {"allowed", allowed},
                     {"why", r.why},
                     {"stack_full", r.outcome.dropped},
                     {"refusal", r.outcome.refusal},
                     {"exceeds_core", r.outcome.exceeds_core},
                     {"digest", hex(r.outcome.digest)},
                     {"seconds", r.outcome.seconds},
                     {"within", r.within()}});
  }
  return {
      {"board", board},
      {"configuration", configuration},
      {"cases", cases},
      {"exceeding", std::ranges::count_if(results, [](const Result& r) { return !r.within(); })},
      {"digest", hex(digest_of(results))},
      {"seconds", seconds}};
}

std::string markdown_of(std::span<const Result> results) {
  std::string text;
  std::string group;
  for (const Result& r : results) {
    if (r.stress->group != group) {
      group = r.stress->group;
      fmt::format_to(
          std::back_inserter(text),
          "\n### {}\n\n| case | scene and rays | rays | errors | reason |\n|---|---|---|---|---|\n",
          group);
    }
    const std::string wrong =
        r.outcome.refusal.empty() ? text_of(r.outcome, r.allowed) : "refused, as it must be";
    fmt::format_to(std::back_inserter(text), "| `{}` | {} | {} | {} | {} |\n", r.stress->name,
                   r.stress->about, r.outcome.rays, wrong, r.why);
  }
  return text;
}

std::uint64_t digest_of(std::span<const Result> results) {
  Outcome all;
  for (const Result& r : results) {
    all.digest_word(static_cast<std::uint32_t>(r.outcome.digest));
    all.digest_word(static_cast<std::uint32_t>(r.outcome.digest >> 32));
  }
  return all.digest;
}

}  // namespace dynrt::host::stress
