// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/app/truth_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "host/analysis/truth/embree_check.h"
#include "host/analysis/truth/rays.h"
#include "host/app/text.h"

namespace dynrt::host {

namespace {

std::string line(const std::string& name, std::uint64_t count, std::uint64_t of) {
  const double share = of == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(of);
  return fmt::format("  {:<44}{:>12}  {:>8.4f} %\n", name, grouped(count), share);
}

}  // namespace

void require_truth() {}  // it is here

WorkReport truth_report(const Prepared& prepared) {
  std::vector<TruthRay> rays;
  const auto& [camera, width, height] = prepared.view;
  rays.reserve(std::size_t{width} * height);
  for (unsigned y = 0; y < height; ++y) {
    for (unsigned x = 0; x < width; ++x) {
      rays.push_back(primary_ray(camera, width, height, x, y));
    }
  }
  const Truth truth(prepared.scene);
  const auto begin = std::chrono::steady_clock::now();
  const auto hits = truth.nearest(rays);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const TruthCounts counts = truth.counts();
  const auto number = static_cast<double>(rays.size());

  std::uint64_t hit = 0, edge = 0, tied = 0;
  for (const auto& h : hits) {
    hit += h.has_value();
    edge += h && h->place != HitPlace::kInside;
    tied += h && !h->ties.empty();
  }
  WorkReport report;
  report.json["truth"] = {{"rays", rays.size()},
                          {"rays_per_second", number / seconds},
                          {"primitives_per_ray", static_cast<double>(counts.primitives) / number},
                          {"exact_per_ray", static_cast<double>(counts.exact) / number},
                          {"hits", hit},
                          {"on_an_edge", edge},
                          {"tied", tied}};
  report.text = fmt::format(
      "truth       {} rays, {:.2f} million a second: {:.1f} primitives a ray tested, {:.3f} "
      "decisions a ray by exact arithmetic\n",
      grouped(rays.size()), number / seconds * 1e-6,
      static_cast<double>(counts.primitives) / number, static_cast<double>(counts.exact) / number);
  report.text += line("hit something", hit, rays.size());
  report.text += line("exactly on an edge or vertex", edge, rays.size());
  report.text += line("several primitives at exactly the same t", tied, rays.size());
  const bool triangles = std::ranges::all_of(prepared.scene.objects, [](const Mesh& mesh) {
    return mesh.primitives() == mesh.triangles.size();
  });
  if (!triangles) {
    report.text += "Embree      not compared, as the scene has rectangles or ellipsoids\n";
    return report;
  }
  const EmbreeComparison embree = compare_with_embree(truth, rays, hits);
  report.json["embree"] = {{"same", embree.same},
                           {"ties", embree.ties},
                           {"near_in_distance", embree.near_in_distance},
                           {"near_an_edge", embree.near_an_edge},
                           {"unexplained", embree.unexplained}};
  report.text += "Embree      in floats, robust:\n";
  report.text += line("the same primitive, or none in both", embree.same, rays.size());
  report.text += line("another at exactly the same t", embree.ties, rays.size());
  report.text += line("another, at a distance that floats cannot tell apart",
                      embree.near_in_distance, rays.size());
  report.text += line("an edge too near for floats", embree.near_an_edge, rays.size());
  report.text += line("not explained", embree.unexplained, rays.size());
  return report;
}

}  // namespace dynrt::host
