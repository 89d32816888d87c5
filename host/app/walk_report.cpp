// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/walk_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/text.h"
#include "host/app/walk_folder.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

double host_seconds(const WalkRecord& record) { return record.tree_seconds + record.pack_seconds; }

double core_seconds(const WalkRecord& record, double clock_hz) {
  return static_cast<double>(record.cycles.value_or(0)) / clock_hz;
}

std::string milliseconds(double seconds) { return fmt::format("{:.2f} ms", 1e3 * seconds); }

/// The first one found an empty board.
std::span<const WalkRecord> later(std::span<const WalkRecord> records) {
  return records.size() > 1 ? records.subspan(1) : records;
}

std::string words_text(double words) { return grouped(static_cast<std::uint64_t>(words + 0.5)); }

template <class Value>
double mean(std::span<const WalkRecord> records, Value&& value) {
  double sum = 0;
  for (const WalkRecord& record : records) sum += static_cast<double>(value(record));
  return records.empty() ? 0 : sum / static_cast<double>(records.size());
}

}  // namespace

double frame_seconds(const WalkRecord& record, double clock_hz) {
  return std::max(core_seconds(record, clock_hz), host_seconds(record)) + record.upload_seconds();
}

std::string walk_header() {
  return fmt::format("  {:>5}{:>10}{:>14}{:>12}{:>12}{:>15}{:>12}\n", "frame", "time", "clocks",
                     "per second", "rebuild", "upload", "on the bus");
}

std::string walk_line(const WalkRecord& record, double clock_hz) {
  const std::string clocks = record.cycles ? grouped(*record.cycles) : "-";
  const std::string rate =
      record.cycles ? fmt::format("{:.2f}", 1 / core_seconds(record, clock_hz)) : "-";
  return fmt::format("  {:>5}{:>10}{:>14}{:>12}{:>12}{:>15}{:>12}{}\n", record.frame,
                     fmt::format("{:.3f} s", record.time), clocks, rate,
                     milliseconds(host_seconds(record)), counted(record.uploaded_words(), "word"),
                     milliseconds(record.upload_seconds()), record.general ? "  general core" : "");
}

std::string WalkSummary::text() const {
  const double clock_hz = clock.hz();
  std::string text = fmt::format("walk        {}", counted(records.size(), "frame"));
  if (kept > 0) text += fmt::format(", {} of them rendered before", kept);
  const auto slowest = std::ranges::max_element(
      records, {}, [&](const WalkRecord& record) { return core_seconds(record, clock_hz); });
  const bool clocked = slowest != records.end() && slowest->cycles;
  if (clocked) {
    const double core = mean(records, [&](const auto& r) { return core_seconds(r, clock_hz); });
    const double all = mean(records, [&](const auto& r) { return frame_seconds(r, clock_hz); });
    text += fmt::format(
        ": {:.2f} frames per second at {:g} MHz, at least {:.2f} (frame {}); {:.2f} with rebuild "
        "and upload",
        1 / core, clock.mhz, 1 / core_seconds(*slowest, clock_hz), slowest->frame, 1 / all);
  }
  text += '\n';
  if (clocked) text += clock.text();
  text += fmt::format("rebuild     {} for each frame\n", milliseconds(mean(records, host_seconds)));
  const auto changing = later(records);
  text +=
      fmt::format("upload      {} of the {} words of a frame ({})",
                  words_text(mean(changing, [](const auto& r) { return r.uploaded_words(); })),
                  words_text(mean(changing, [](const auto& r) { return r.words; })),
                  milliseconds(mean(changing, [](const auto& r) { return r.upload_seconds(); })));
  if (scene_upload.bytes_written > 0) {  // not when all frames were there
    text +=
        fmt::format(", after {} words of objects once ({})",
                    grouped(scene_upload.bytes_written / 4), milliseconds(scene_upload.seconds()));
  }
  return text + "\n";
}

Json WalkSummary::json() const {
  const double clock_hz = clock.hz();
  Json frames = Json::array();
  bool clocked = !records.empty();
  for (const WalkRecord& record : records) {
    Json frame = json_of(record);
    clocked &= record.cycles.has_value();
    const auto or_null = [&](double seconds) { return record.cycles ? Json(1 / seconds) : Json(); };
    frame["frames_per_second"] = or_null(core_seconds(record, clock_hz));
    frame["frames_per_second_with_upload"] = or_null(frame_seconds(record, clock_hz));
    frames.push_back(std::move(frame));
  }
  const auto rate = [&](const auto& seconds) {
    return clocked ? Json(1 / mean(records, seconds)) : Json();
  };
  return {
      {"clock_hz", clock_hz},
      {"clock", clock.json()},
      {"kept", kept},
      {"frames_per_second", rate([&](const WalkRecord& r) { return core_seconds(r, clock_hz); })},
      {"frames_per_second_with_upload",
       rate([&](const WalkRecord& r) { return frame_seconds(r, clock_hz); })},
      {"rebuild_seconds", mean(records, host_seconds)},
      {"uploaded_words", mean(later(records), [](const auto& r) { return r.uploaded_words(); })},
      {"scene_upload",
       {{"words", scene_upload.bytes_written / 4},
        {"transactions", scene_upload.transactions},
        {"bus_clocks", scene_upload.bus_clocks},
        {"bus_clock_hz", scene_upload.clock_hz}}},
      {"frames", frames}};
}

}  // namespace dynrt::host
