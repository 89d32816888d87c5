// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/work_report.h"

#include <fmt/format.h>

#include <iterator>
#include <limits>

#include "host/analysis/counts/overlap.h"
#include "host/app/progress.h"
#include "host/app/text.h"

namespace dynrt::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned kUnlimited = std::numeric_limits<unsigned>::max();

double millions(std::uint64_t count) { return static_cast<double>(count) / 1e6; }

Json json_of(const WorkCounts& work) {
  return {{"packets", work.packets},
          {"top_steps", work.top_steps},
          {"object_steps", work.object_steps},
          {"leaf_fetches", work.leaf_fetches},
          {"empty_leaves", work.empty_leaves},
          {"list_entries", work.list_entries},
          {"objects", work.objects},
          {"triangles", work.triangles},
          {"hits", work.hits},
          {"dropped_pushes", work.dropped_pushes},
          {"bound_clocks", work.bound()}};
}

/// Traces a scene again and again at one size and sees to it that the picture stays the same.
class WorkCounter {
 public:
  WorkCounter(const Prepared& prepared, unsigned runs)
      : plain{prepared.trees.instances, {}},
        prepared_(prepared),
        width_(prepared.view.width),
        height_(prepared.view.height),
        progress_(fmt::format("counting the work of {}", prepared.scene.name), runs) {}

  WorkCounts count(const TopLevel& top, const TraceOptions& options) {
    TracedFrame frame = trace_frame(prepared_.scene, prepared_.trees.objects, top,
                                    prepared_.view.camera, width_, height_, options);
    if (hits_.empty()) hits_ = std::move(frame.hits);
    for (std::size_t i = 0; i < frame.hits.size(); ++i) {
      different_ += frame.hits[i].hit != hits_[i].hit || frame.hits[i].t != hits_[i].t;
    }
    progress_.update(++done_);
    return frame.work;
  }

  /// The head of a report's text and its data.
  std::string head(const std::string& about) const {
    return fmt::format(
        "scene       {}: {} of {}, {} triangles\n"
        "counted     {}x{} primary rays, traced in doubles; {}\n\n",
        prepared_.scene.name, counted(prepared_.scene.instances.size(), "instance"),
        counted(prepared_.scene.objects.size(), "object"), grouped(prepared_.instanced_triangles()),
        width_, height_, about);
  }
  std::string foot() const {
    return fmt::format("\npixels that differ between the rows: {}\n", grouped(different_));
  }
  Json json(const char* report, Json rows) const {
    return {{"report", report},  {"scene", prepared_.scene.name},  {"width", width_},
            {"height", height_}, {"different_pixels", different_}, {"rows", std::move(rows)}};
  }

  const TopLevel plain;

 private:
  const Prepared& prepared_;
  unsigned width_, height_;
  Progress progress_;
  std::vector<TracedHit> hits_;
  std::uint64_t different_ = 0, done_ = 0;
};

/// Millions of operations of Table 4.1: the thesis's conference scene at 1024x768.
struct Thesis {
  double steps, objects, triangles;
};

struct Method {
  const char* name;
  const char* key;
  const TopLevel* top;
  TraceOptions options;
  Thesis thesis;  ///< zero: not in the table
};

double per_packet(std::uint64_t count, const WorkCounts& work) {
  return static_cast<double>(count) / static_cast<double>(work.packets);
}

constexpr char kPacketsAbout[] = "per packet of 2x2; bound: clocks of the busiest unit";

}  // namespace

WorkReport overlap_report(const Prepared& prepared) {
  std::vector<Aabb> boxes;
  for (const Tree& tree : prepared.trees.objects) boxes.push_back(tree.box);
  const TopLevel hierarchy = hierarchical_top_level(prepared.trees.instances);
  const TopLevel main_first = main_scene_first(prepared.scene, boxes);
  TraceOptions none;
  none.object_slots = none.triangle_slots = 0;
  TraceOptions last_objects = none;
  last_objects.object_slots = TraceOptions{}.object_slots;
  last_objects.keeps_latest = true;
  WorkCounter counter(prepared, 10);
  const Method methods[] = {
      {"none", "none", &counter.plain, none, {295.4, 6.4, 57.6}},
      {"hierarchical tree", "hierarchical", &hierarchy, none, {70.3, 2.0, 10.9}},
      {"mailbox, last 8 objects", "mailbox", &counter.plain, last_objects, {63.2, 1.6, 10.3}},
      {"mailbox of the core", "core", &counter.plain, {}, {}},
      {"multiple scenes", "multiple_scenes", &main_first, none, {71.5, 2.1, 11.3}}};

  std::string text = fmt::format("{:<24}{:>24}{:>24}{:>24}\n{:<24}", "", "traversal steps",
                                 "objects", "triangles", "millions");
  for (int i = 0; i < 3; ++i) {
    fmt::format_to(std::back_inserter(text), "{:>8}{:>8}{:>8}", "thesis", "rays", "packets");
  }
  text += '\n';
  Json rows = Json::array();
  for (const Method& method : methods) {
    TraceOptions options = method.options;
    options.single_rays = true;
    const WorkCounts rays = counter.count(*method.top, options);
    const WorkCounts packets = counter.count(*method.top, method.options);
    const bool in_thesis = method.thesis.steps > 0;
    const auto cells = [&](double thesis, std::uint64_t ray, std::uint64_t packet) {
      return fmt::format("{:>8}{:>8.1f}{:>8.1f}", in_thesis ? fmt::format("{:.1f}", thesis) : "-",
                         millions(ray), millions(packet));
    };
    fmt::format_to(std::back_inserter(text), "{:<24}{}{}{}\n", method.name,
                   cells(method.thesis.steps, rays.steps(), packets.steps()),
                   cells(method.thesis.objects, rays.objects, packets.objects),
                   cells(method.thesis.triangles, rays.triangles, packets.triangles));
    Json row = {{"method", method.key}, {"rays", json_of(rays)}, {"packets", json_of(packets)}};
    if (in_thesis) {
      row["thesis_millions"] = {{"steps", method.thesis.steps},
                                {"objects", method.thesis.objects},
                                {"triangles", method.thesis.triangles}};
    }
    rows.push_back(std::move(row));
  }
  text +=
      "\nThe columns of the thesis are its Table 4.1: its own conference scene at 1024x768, one "
      "ray at a\ntime. Objects and triangles are those that are transformed and intersected. The "
      "core's mailbox\nkeeps the first 8 objects and the first 8 triangles of a packet; the "
      "mailboxes of the other rows\nkeep no triangles.\n";
  return {counter.head("one ray at a time, and packets of 2x2") + text + counter.foot(),
          counter.json("overlap", std::move(rows))};
}

WorkReport mailbox_report(const Prepared& prepared) {
  struct Slots {
    unsigned objects, triangles;
  };
  constexpr Slots kSlots[] = {{0, 0},   {1, 1},   {2, 2}, {4, 4}, {8, 8},
                              {16, 16}, {32, 32}, {8, 0}, {0, 8}};
  WorkCounter counter(prepared, std::size(kSlots) + 1);
  TraceOptions options;
  options.object_slots = options.triangle_slots = kUnlimited;
  const WorkCounts all = counter.count(counter.plain, options);
  std::string text = "      slots for        objects transformed   triangles transformed\n";
  fmt::format_to(std::back_inserter(text), "{:>9}{:>11}{:>11}{:>9}{:>14}{:>10}{:>9}{:>9}\n",
                 "objects", "triangles", "all", "again", "all", "again", "steps", "bound");
  Json rows = Json::array();
  for (const Slots& slots : kSlots) {
    options.object_slots = slots.objects;
    options.triangle_slots = slots.triangles;
    const WorkCounts work = counter.count(counter.plain, options);
    fmt::format_to(std::back_inserter(text),
                   "{:>9}{:>11}{:>11.3f}{:>9.3f}{:>14.3f}{:>10.3f}{:>9.2f}{:>9.2f}\n",
                   slots.objects, slots.triangles, per_packet(work.objects, work),
                   per_packet(work.objects - all.objects, work), per_packet(work.triangles, work),
                   per_packet(work.triangles - all.triangles, work), per_packet(work.steps(), work),
                   per_packet(work.bound(), work));
    rows.push_back({{"object_slots", slots.objects},
                    {"triangle_slots", slots.triangles},
                    {"objects_again", work.objects - all.objects},
                    {"triangles_again", work.triangles - all.triangles},
                    {"packets", json_of(work)}});
  }
  const TraceOptions core;
  text += fmt::format(
      "\n\"again\" counts the tests that unlimited slots would avoid. A packet that enters an "
      "object again\nmeets its triangles again. The core has {} and {} slots.\n",
      core.object_slots, core.triangle_slots);
  return {counter.head(kPacketsAbout) + text + counter.foot(),
          counter.json("mailbox", std::move(rows))};
}

WorkReport clipping_report(const Prepared& prepared) {
  struct Way {
    const char* name;
    const char* key;
    Clipping scene, objects;
    bool free = false;
  };
  using enum Clipping;
  constexpr Way kWays[] = {
      {"none", "none", kNever, kNever},
      {"the scene", "scene", kAlways, kNever},
      {"objects", "objects", kNever, kAlways},
      {"the scene and objects", "both", kAlways, kAlways},
      {"both, where the camera is outside", "from_outside", kFromOutside, kFromOutside},
      {"the same, object clipping free", "objects_free", kFromOutside, kFromOutside, true}};
  WorkCounter counter(prepared, std::size(kWays));
  std::string text = fmt::format("{:<34}{:>9}{:>9}{:>9}{:>11}{:>9}\n", "clipping to the boxes of",
                                 "top", "inside", "objects", "triangles", "bound");
  Json rows = Json::array();
  for (const Way& way : kWays) {
    TraceOptions options;
    options.scene_clipping = way.scene;
    options.object_clipping = way.objects;
    options.object_clip_free = way.free;
    const WorkCounts work = counter.count(counter.plain, options);
    fmt::format_to(std::back_inserter(text), "{:<34}{:>9.2f}{:>9.2f}{:>9.2f}{:>11.2f}{:>9.2f}\n",
                   way.name, per_packet(work.top_steps, work), per_packet(work.object_steps, work),
                   per_packet(work.objects, work), per_packet(work.triangles, work),
                   per_packet(work.bound(), work));
    rows.push_back({{"clipping", way.key}, {"packets", json_of(work)}});
  }
  text +=
      "\n\"top\" and \"inside\" count the traversal steps of the instances' tree and of the "
      "objects' trees.\nThe host works like the row before the last: a frame, or a visit of an "
      "object, starts at the six\nclipping nodes only if the camera is outside the box.\n";
  return {counter.head(kPacketsAbout) + text + counter.foot(),
          counter.json("clipping", std::move(rows))};
}

}  // namespace dynrt::host
