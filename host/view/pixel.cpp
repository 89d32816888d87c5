// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/pixel.h"

#include "host/view/hit_json.h"
#include "host/view/way.h"

namespace dynrt::host {

namespace {

Json names_json(const Scene& scene, const PrimitiveId& id) {
  const Instance& instance = scene.instances[id.instance];
  const Mesh& mesh = scene.objects[instance.object];
  return {{"instance", id.instance},
          {"instance_name", instance.name},
          {"object", mesh.name},
          {"primitive", id.primitive},
          {"material", scene.materials[mesh.material_of(id.primitive)].name}};
}

Json packet_json(const PacketWork& packet, const FrameWatch& watch, bool clocked) {
  return {{"x", packet.x},
          {"y", packet.y},
          {"columns", watch.columns},
          {"rows", watch.rows},
          {"begin", clocked ? Json(packet.begin) : Json()},
          {"end", clocked ? Json(packet.end) : Json()},
          {"nodes", packet.nodes},
          {"lists", packet.lists},
          {"entries", packet.entries},
          {"objects", packet.objects},
          {"triangles", packet.triangles},
          {"misses", packet.misses}};
}

}  // namespace

Json pixel_json(const Scenery& scenery, const Still& still, unsigned x, unsigned y, bool way) {
  const Scene& scene = scenery.image().scene;
  const std::size_t pixel = still.index(x, y);
  const auto primitive = still.primitive_at(pixel);
  Json json = {{"number", still.number}, {"record", hit_json(still.frame, x, y)}};
  json["names"] = primitive ? names_json(scene, *primitive) : Json();
  json["truth"] = Json();
  if (still.truth) {
    const FrameRays rays{still.camera, still.shot.width, still.shot.height};
    Json truth =
        still.truth->pixel(rays, x, y, still.frame.hits[pixel], primitive, *scenery.core().format);
    if (truth["hit"] == true) {
      truth["names"] = names_json(scene, {truth["instance"], truth["primitive"]});
    }
    json["truth"] = std::move(truth);
  }
  json["packet"] = Json();
  if (const PacketWork* packet = still.packet_at(x, y)) {
    json["packet"] = packet_json(*packet, *still.watch, still.watched->run.cycles.has_value());
    if (way) json["way"] = way_json(scenery, still, *packet);
  }
  return json;
}

}  // namespace dynrt::host
