#include "Scene/KeyImagesJson.h"

#include "Scene/CameraJson.h"
#include "Scene/SlicesJson.h"

#include <nlohmann/json.hpp>

namespace varimarch
{

std::vector<KeyImage> KeyImagesFromJson(const JsonCursor& scene)
{
  std::vector<KeyImage> images;
  const auto list = scene.Find("keyImages");
  for (const JsonCursor& json : list ? list->Elements(0, MostKeyImages) : std::vector<JsonCursor>())
  {
    json.RequireObject({ "view", "name", "slices", "camera" });
    images.push_back({ json.At("view").Choice(KeyViewNames()), json.At("name").Text(),
      SlicesFromJson(json.At("slices")), CameraFromJson(json.At("camera")) });
  }
  return images;
}

nlohmann::ordered_json JsonFromKeyImages(const std::vector<KeyImage>& images)
{
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const KeyImage& image : images)
  {
    list.push_back({ { "view", NameOf(KeyViewNames(), image.view) }, { "name", image.name },
      { "slices", JsonFromSlices(image.slices) }, { "camera", JsonFromCamera(image.camera) } });
  }
  return list;
}

}
