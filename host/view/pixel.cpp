// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/pixel.h"

#include "host/render/hit_json.h"
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

Json pixel_json(const LoadedScene& loaded, const FullPicture& picture, unsigned x, unsigned y,
                bool way) {
  const Scene& scene = loaded.image().scene;
  const std::size_t pixel = picture.index(x, y);
  const auto primitive = picture.primitive_at(pixel);
  Json json = {{"number", picture.number}, {"record", hit_json(picture.frame, x, y)}};
  json["names"] = primitive ? names_json(scene, *primitive) : Json();
  json["truth"] = Json();
  if (picture.truth) {
    const FrameRays rays{picture.camera, picture.request.width, picture.request.height};
    Json truth = picture.truth->pixel(rays, x, y, picture.frame.hits[pixel], primitive,
                                      *loaded.core().format);
    if (truth["hit"] == true) {
      truth["names"] = names_json(scene, {truth["instance"], truth["primitive"]});
    }
    json["truth"] = std::move(truth);
  }
  json["packet"] = Json();
  if (const PacketWork* packet = picture.packet_at(x, y)) {
    json["packet"] = packet_json(*packet, *picture.watch, picture.watched->run.cycles.has_value());
    if (way) json["way"] = way_json(loaded, picture, *packet);
  }
  return json;
}

}  // namespace dynrt::host
