#include "Scene/KeyImagesJson.h"

#include "Scene/CameraJson.h"
#include "Scene/SlicesJson.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace varimarch
{

std::vector<KeyImage> KeyImagesFromJson(const JsonCursor& scene)
{
  std::vector<KeyImage> images;
  const auto list = scene.Find("keyImages");
  for (const JsonCursor& json : list ? list->Elements(0, MostKeyImages) : std::vector<JsonCursor>())
  {
    json.RequireObject({ "view", "name", "slices", "camera", "time" });
    images.push_back({ json.At("view").Choice(KeyViewNames()), json.At("name").Text(),
      SlicesFromJson(json.At("slices")), CameraFromJson(json.At("camera")) });
    if (const auto time = json.Find("time"))
    {
      images.back().time = time->Integer(0, std::numeric_limits<int>::max());
    }
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
    if (image.time)
    {
      list.back()["time"] = *image.time;
    }
  }
  return list;
}

}
