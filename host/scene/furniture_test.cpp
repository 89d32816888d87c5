// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
#include "host/scene/furniture.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <string>

#include "host/scene/camera.h"
#include "host/scene/test_files.h"
#include "host/scene/test_zip.h"

namespace dynrt::host {
namespace {

struct Expected {
  const char* id;
  std::size_t triangles;  // of the file, those of zero area included
};

constexpr Expected kOfficeModels[] = {
    {"Scopia#office_chair", 9336},
    {"Scopia#apple_pc", 7224},
    {"Scopia#phone", 1348},
    {"Scopia#bandeja", 326},
    {"Scopia#inkjet_and_scanner_printer", 738},
    {"Scopia#office_furniture1", 1098},
    {"Scopia#water_cooler", 2510},
    {"Scopia#door", 3072},
    {"Blend Swap CC-BY#officeTable", 4190},
    {"Kator Legaz#filing-cabinet", 628},
    {"Kator Legaz#window-01", 616},
    {"Blend Swap CC-0#whiteBoard", 2478},
};

TEST(Furniture, HasTheModelsOfTheOfficeTriangleByTriangle) {
  const Furniture furniture;
  for (const Expected& expected : kOfficeModels) {
    const auto entry = furniture.find(expected.id);
    ASSERT_TRUE(entry) << expected.id;
    const Scene scene = furniture.load(*entry);
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].triangles.size() + scene.dropped.zero_area_triangles,
              expected.triangles)
        << expected.id;
    EXPECT_EQ(scene.dropped.points_and_lines, 0u);
    EXPECT_TRUE(scene.notes.empty()) << scene.notes[0];
  }
}

TEST(Furniture, ScalesTheBoundingBoxToTheCataloguesSize) {
  const Furniture furniture;
  for (const Expected& expected : kOfficeModels) {
    const auto entry = furniture.find(expected.id);
    ASSERT_TRUE(entry);
    for (const glm::dvec3& size : {entry->size, glm::dvec3(1, 2, 3)}) {
      const Box box = bounds(furniture.load(*entry, size));
      EXPECT_LT(glm::length(box.high - box.low - size), 1e-9) << expected.id;
      EXPECT_LT(glm::length(box.low - glm::dvec3(-size.x / 2, 0, -size.z / 2)), 1e-9);
    }
  }
}

TEST(Furniture, ReadsTheCatalogue) {
  const auto chair = Furniture().find("Scopia#office_chair");
  ASSERT_TRUE(chair);
  EXPECT_NEAR(chair->size.x, 0.635, 1e-12);
  EXPECT_NEAR(chair->size.y, 1.0, 1e-12);
  EXPECT_NEAR(chair->size.z, 0.637, 1e-12);
  EXPECT_EQ(chair->creator, "Scopia");
  EXPECT_EQ(chair->model, "scopia/office_chair/office_chair.obj");
  EXPECT_EQ(chair->rotation, glm::dmat3(1.0));
  EXPECT_FALSE(Furniture().find("Scopia#no_such_thing"));
}

TEST(Furniture, TakesColoursFromTheMaterialFileInTheZip) {
  const Furniture furniture;
  const Scene chair = furniture.load(*furniture.find("Scopia#office_chair"));
  bool has_blue_cloth = false;
  for (const Material& material : chair.materials) {
    has_blue_cloth |=
        material.name == "tela_sillon_azul" &&
        glm::length(material.diffuse - glm::dvec3(0.086577, 0.227787, 0.356577)) < 1e-6;
  }
  EXPECT_TRUE(has_blue_cloth);
}

// The rows of the headphones' modelRotation are 0 0 1, -1 0 0, 0 -1 0.
TEST(Furniture, TurnsAModelAsTheCatalogueSays) {
  const auto headphones = Furniture().find("Blend Swap CC-0#headphones");
  ASSERT_TRUE(headphones);
  EXPECT_EQ(headphones->rotation * glm::dvec3(1, 2, 3), glm::dvec3(3, -1, -2));
  const Box box = bounds(Furniture().load(*headphones));
  EXPECT_LT(glm::length(box.high - box.low - headphones->size), 1e-9);
}

TEST(Furniture, NamesThePackageThatIsMissing) {
  const TestFolder folder;
  for (const std::string& path : {folder.path(""), folder.path("gone")}) {
    EXPECT_EQ(user_error([&] { Furniture furniture(path); }),
              "the models of this scene come from the Debian package sweethome3d-furniture, which "
              "is not installed (" +
                  path +
                  " has no .sh3f file); install it with: apt-get install sweethome3d-furniture");
  }
}

TEST(Furniture, NamesWhatIsWrongInALibrary) {
  const TestFolder folder;
  const std::string path = folder.path("own.sh3f");
  const auto error = [&](const std::map<std::string, std::string>& files) {
    write_zip(path, files);
    const std::string text = user_error([&] {
      const Furniture furniture(folder.path(""));
      furniture.load(furniture.find("own#a").value());
    });
    return text.substr(std::min(path.size(), text.size()));
  };
  const std::string catalogue = "PluginFurnitureCatalog.properties";
  const std::string entry = "id#1=own#a\nmodel#1=/a/a.obj\nwidth#1=100\nheight#1=50\n";
  EXPECT_EQ(error({{"other.txt", "x"}}),
            ": cannot read this zip library (it does not hold PluginFurnitureCatalog.properties); "
            "reinstall the package sweethome3d-furniture");
  EXPECT_EQ(error({{catalogue, entry}}),
            ": the catalogue's entry 'own#a' has no usable 'depth'; reinstall the package "
            "sweethome3d-furniture");
  EXPECT_EQ(error({{catalogue, entry + "depth#1=10\nmodelRotation#1=1 0 0 0 1 0 0 0\n"}}),
            ": the catalogue's entry 'own#a' has no usable 'modelRotation'; reinstall the package "
            "sweethome3d-furniture");
  EXPECT_EQ(error({{catalogue, entry + "depth#1=10\n"}}),
            ": cannot read this zip library (a/a.obj is missing); reinstall the package "
            "sweethome3d-furniture");
  EXPECT_EQ(error({{catalogue, entry + "depth#1=10\n"}, {"a/a.obj", "v 0 0 0\nf 1 2 3\n"}}),
            ":a/a.obj: not a valid OBJ file: OBJ: vertex index out of range");
}

TEST(Furniture, NamesALibraryThatIsBroken) {
  const TestFolder folder;
  const std::string path = folder.write("a.sh3f", "no zip");
  const std::string error = user_error([&] { Furniture furniture(folder.path("")); });
  EXPECT_EQ(error, path +
                       ": cannot read this zip library (Not a zip archive); reinstall the package "
                       "sweethome3d-furniture");
}

}  // namespace
}  // namespace dynrt::host
