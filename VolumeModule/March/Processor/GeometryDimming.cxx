#include "March/Processor/GeometryDimming.h"

#include "Core/Packets/PacketMarch.h"
#include "March/Processor/GeometryLight.h"
#include "March/Processor/GeometryReceivers.h"
#include "March/Processor/PacketScenes.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

constexpr int LightsAtOnce = 4; ///< as many as a pixel has numbers

using Receivers = std::vector<GeometryReceiver>;

// The parts of the lights that a volume lets through to receivers: for each four lights the numbers
// of all pixels.
std::vector<std::vector<float>> PartsOfLights(PacketScene scene, const glm::dmat4& gridFromWorld,
  const Viewport& pixels, const Receivers& receivers)
{
  std::vector<glm::vec4> places(std::size_t(pixels.width) * std::size_t(pixels.height));
  for (const GeometryReceiver& receiver : receivers)
  {
    places[receiver.pixel] = gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0);
  }
  std::vector<std::vector<float>> parts;
  const int count =
    std::min(scene.parameters.distantCount + scene.parameters.nearCount, MostShadowedLights);
  for (int first = 0; first < count; first += LightsAtOnce)
  {
    scene.receivers = { places.data(), pixels, first };
    parts.emplace_back(4 * places.size());
    MarchPackets(scene, pixels, parts.back().data());
  }
  return parts;
}

// The factors of all pixels, 1 where no receiver is.
std::vector<float> FactorsOf(const Frame& frame, const Viewport& pixels, const Receivers& receivers,
  const std::vector<std::vector<float>>& parts)
{
  const GeometryLight light(frame);
  const double strength = frame.material.surfacesInShadow;
  std::vector<float> factors(4 * std::size_t(pixels.width) * std::size_t(pixels.height), 1.0f);
  tbb::parallel_for(std::size_t(0), receivers.size(),
    [&](std::size_t i)
    {
      const GeometryReceiver& receiver = receivers[i];
      const auto partOf = [&](int lamp)
      {
        const auto group = std::size_t(lamp / LightsAtOnce);
        const double part = group < parts.size()
          ? parts[group][4 * receiver.pixel + std::size_t(lamp % LightsAtOnce)]
          : 1.0;
        return 1.0 - strength * (1.0 - part);
      };
      const glm::dvec3 own = light.FactorsAt(receiver, partOf);
      for (int channel = 0; channel < 3; ++channel)
      {
        factors[4 * receiver.pixel + std::size_t(channel)] = float(own[channel]);
      }
    });
  return factors;
}

// A box in the grid whose inner faces cover all receivers on the screen.
Box CoverOf(const Box& boxGrid, const glm::dmat4& gridFromWorld, const Receivers& receivers)
{
  Box box = boxGrid;
  for (const GeometryReceiver& receiver : receivers)
  {
    const glm::dvec3 place(gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0));
    box = { glm::min(box.lower, place), glm::max(box.upper, place) };
  }
  return WithItsEdges(box);
}

}

void GeometryDimming::Draw(const Frame& frame, const MarchPlan& plan)
{
  const bool mayDim = frame.settings.casters && frame.settings.sceneGeometry &&
    frame.material.surfacesInShadow > 0.0 && !plan.isInteractive &&
    !this->resources.IsNothingDrawn();
  const Receivers receivers =
    mayDim ? GeometryReceiversOf(frame, this->resources, plan.viewport) : Receivers();
  if (receivers.empty())
  {
    this->Release(frame.view.window);
    return;
  }
  const Viewport pixels = { 0, 0, plan.viewport.width, plan.viewport.height };
  PacketSurroundings around = {};
  around.drawnBox = this->resources.DrawnBox();
  around.depthPixels = this->resources.Depth().SizePixels();
  around.textures = this->resources.Textures();
  const PacketScenes scenes(MarchOf(frame, plan), this->resources, std::move(around), pixels);
  const glm::dmat4 gridFromWorld = glm::inverse(frame.geometry.worldFromGrid);
  const std::vector<float> rgba = FactorsOf(
    frame, pixels, receivers, PartsOfLights(scenes.Scene(), gridFromWorld, pixels, receivers));
  this->factors.Take(frame.view.window, rgba, pixels);

  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = CoverOf(frame.geometry.boxGrid, gridFromWorld, receivers);
  EarlierDrawings earlier;
  earlier.marched = this->factors.Texture();
  earlier.marchedPixels = pixels;
  this->boxes.Draw(frame, plan.WithRole(ShaderRole::DimGeometry), drawn, earlier);
}

}
