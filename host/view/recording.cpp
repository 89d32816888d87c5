// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/view/recording.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "host/error.h"
#include "host/render/hit_json.h"
#include "host/view/maps.h"
#include "host/view/pixel.h"
#include "host/view/way.h"

namespace dynrt::host {

namespace {

constexpr char kNamed[] = "from \"view/";  ///< as the map of imports has it

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

/// As browsers unpack it ("deflate").
std::string packed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(),
                Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib cannot compress the recorded frame");
  }
  out.resize(size);
  return out;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// The text without sequences that would end its <script> element.
std::string in_script(std::string text) {
  replace_all(text, "</script", "<\\/script");
  replace_all(text, "<!--", "<\\!--");
  return text;
}

/// Boxes and corners that many packets meet, each once.
class Places {
 public:
  /// Replaces the step's place by its number.
  void shorten(Json& step) {
    for (const char* name : {"box", "corners"}) {
      if (!step.contains(name)) continue;
      const auto [known, is_new] = numbers_.try_emplace(step[name].dump(), places_.size());
      if (is_new) places_.push_back(step[name]);
      step[name] = known->second;
    }
  }
  const Json& all() const { return places_; }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  Json places_ = Json::array();
};

Json packets_json(const LoadedScene& loaded, const FullPicture& picture, Places& places) {
  Json packets = Json::array();
  for (const PacketWork& packet : picture.watch->packets) {
    Json way = way_json(loaded, picture, packet);
    for (Json& step : way) places.shorten(step);
    packets.push_back(std::move(way));
  }
  return packets;
}

/// The answer for each pixel; its "way" is the number of its packet.
Json pixels_json(const LoadedScene& loaded, const FullPicture& picture) {
  Json pixels = Json::array();
  for (unsigned y = 0; y < picture.request.height; ++y) {
    for (unsigned x = 0; x < picture.request.width; ++x) {
      Json pixel = pixel_json(loaded, picture, x, y, false);
      pixel["way"] = picture.packet_of[picture.index(x, y)];
      pixels.push_back(std::move(pixel));
    }
  }
  return pixels;
}

Answer recorded(const LoadedScene& loaded, const FullPicture& picture) {
  Answer answer;
  answer.words = picture.frame.pixels;
  Places places;
  answer.head["pixels"] = pixels_json(loaded, picture);
  answer.head["columns"] = kHitColumns;
  answer.head["packets"] = packets_json(loaded, picture, places);
  answer.head["places"] = places.all();
  answer.head["maps"] = Json::array();
  for (const MapDefinition& map : view_maps()) {
    try {
      Answer drawn = map_of(loaded, picture, map.name);
      answer.head["maps"].push_back(std::move(drawn.head));
      answer.words.insert(answer.words.end(), drawn.words.begin(), drawn.words.end());
    } catch (const UserError&) {
      // The page offers no map that needs true hits or clocks which this build lacks.
    }
  }
  return answer;
}

std::string imports(const std::map<std::string, PageFile>& files) {
  Json map = Json::object();
  for (const auto& [path, file] : files) {
    if (!path.ends_with(".js") || path == "/d3.js" || path == "/recorded.js") continue;
    std::string text = (path == "/ask.js" ? files.at("/recorded.js") : file).text;
    replace_all(text, "from \"./", kNamed);
    map["view" + path] = "data:text/javascript;base64," + base64(text);
  }
  return Json{{"imports", map}}.dump();
}

[[noreturn]] void refuse_size(unsigned width, unsigned height) {
  refuse(
      "the recorded frame of {}x{} pixels would take more than {} MB, the most that a file may "
      "have; record a smaller picture",
      width, height, kMostRecordedBytes / 1'000'000);
}

}  // namespace

void check_recorded_size(unsigned width, unsigned height) {
  if (std::uint64_t{width} * height > kMostRecordedPixels) refuse_size(width, height);
}

std::string recorded_page(const std::map<std::string, PageFile>& files, const LoadedScene& loaded,
                          const FullPicture& picture, const Json& start, const Json& frame,
                          const Json& machine) {
  Answer answer = recorded(loaded, picture);
  answer.head["start"] = start;
  answer.head["frame"] = frame;
  answer.head["machine"] = machine;
  Json offered = Json::array();
  for (const Json& map : start.at("maps")) {
    const auto is_drawn = [&](const Json& drawn) { return drawn["name"] == map["name"]; };
    if (std::ranges::any_of(answer.head["maps"], is_drawn)) offered.push_back(map);
  }
  answer.head["start"]["maps"] = std::move(offered);
  answer.head["start"]["recorded"] = true;
  answer.head["start"]["seconds"] = 0;  // one moment

  constexpr char kPolicy[] =
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: "
      "blob:; style-src 'unsafe-inline'; script-src 'unsafe-inline' data:\">\n";
  std::string page = files.at("/index.html").text;
  const auto put = [&page](std::string_view old, const std::string& text) {
    const std::size_t at = page.find(old);
    if (at == page.npos) throw std::logic_error(fmt::format("the page lacks {}", old));
    page.replace(at, old.size(), text);
  };
  put("<link rel=\"stylesheet\" href=\"style.css\">",
      kPolicy + fmt::format("<style>{}</style>", files.at("/style.css").text));
  put("<script src=\"d3.js\"></script>",
      fmt::format("<script>{}</script>", in_script(files.at("/d3.js").text)));
  put("<script type=\"module\" src=\"main.js\"></script>",
      fmt::format("<script type=\"importmap\">{}</script>\n", imports(files)));
  put("</body>", fmt::format("<script type=\"text/plain\" id=\"recorded\">{}</script>\n"
                             "<script type=\"module\">import \"view/main.js\";</script>\n</body>",
                             base64(packed(answer.bytes()))));
  if (page.size() > kMostRecordedBytes) {
    refuse_size(picture.request.width, picture.request.height);
  }
  return page;
}

}  // namespace dynrt::host
