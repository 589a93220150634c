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

// The places of all pixels [grid space], with 1 as fourth number, or 0 where no receiver is.
std::vector<glm::vec4> PlacesOf(
  const Receivers& receivers, const glm::dmat4& gridFromWorld, const Viewport& pixels)
{
  std::vector<glm::vec4> places(std::size_t(pixels.width) * std::size_t(pixels.height));
  for (const GeometryReceiver& receiver : receivers)
  {
    places[receiver.pixel] = gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0);
  }
  return places;
}

// The pixels of a plan's viewport, counted from its corner.
Viewport PixelsOf(const MarchPlan& plan)
{
  return { 0, 0, plan.viewport.width, plan.viewport.height };
}

// The factors of all pixels, 1 where no receiver is.
// @param parts  of the lights, for each four of them the numbers of all pixels
std::vector<glm::vec4> FactorsOf(const Frame& frame, std::size_t pixelCount,
  const Receivers& receivers, const std::vector<std::vector<float>>& parts)
{
  const GeometryLight light(frame);
  const double strength = frame.material.surfacesInShadow;
  std::vector<glm::vec4> factors(pixelCount, glm::vec4(1.0f));
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
      factors[receiver.pixel] = glm::dvec4(light.FactorsAt(receiver, partOf), 1.0);
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

// A shader sees one block of a volume at a time, and one of several volumes.
bool GeometryDimming::MayDim(const Frame& frame, const MarchPlan& plan) const
{
  const bool sees = plan.marcher == Marcher::Processor ||
    (!this->resources.IsInBlocks() && frame.others.empty() && frame.userCode.IsEmpty());
  return sees && frame.settings.casters && frame.casters.mayReceive &&
    frame.settings.sceneGeometry && !plan.isInteractive && !this->resources.IsNothingDrawn();
}

std::vector<std::vector<float>> GeometryDimming::LightByPackets(
  const Frame& frame, const MarchPlan& plan, const std::vector<glm::vec4>& places)
{
  const Viewport pixels = PixelsOf(plan);
  PacketSurroundings around = {};
  around.drawnBox = this->resources.DrawnBox();
  around.depthPixels = this->resources.Depth().SizePixels();
  around.textures = this->resources.Textures();
  const PacketScenes scenes(MarchOf(frame, plan), this->resources, std::move(around), pixels);
  PacketScene scene = scenes.Scene();
  const int count =
    std::min(scene.parameters.distantCount + scene.parameters.nearCount, MostShadowedLights);
  std::vector<std::vector<float>> parts;
  for (int first = 0; first < count; first += LightsAtOnce)
  {
    scene.receivers = { places.data(), pixels, first };
    parts.emplace_back(4 * places.size());
    MarchPackets(scene, pixels, parts.back().data());
  }
  return parts;
}

std::vector<std::vector<float>> GeometryDimming::LightByShader(const Frame& frame,
  const MarchPlan& plan, const std::vector<glm::vec4>& places, const Box& coverGrid)
{
  vtkOpenGLRenderWindow* const window = frame.view.window;
  const Viewport pixels = PixelsOf(plan);
  this->image.Take(window, places, pixels);
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.block = &this->resources.First().Blocks().Take(window, 0);
  drawn.voxels = { glm::ivec3(0), frame.geometry.dimensions };
  drawn.coverGrid = coverGrid;
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = pixels;
  const MarchPlan tracing = plan.WithRole(ShaderRole::LightPlaces).WithViewport(pixels);
  this->light.Draw(window, pixels, [&] { this->boxes.Draw(frame, tracing, drawn, earlier); });
  return { this->light.Read(window, pixels, 0), this->light.Read(window, pixels, 1) };
}

void GeometryDimming::Draw(const Frame& frame, const MarchPlan& plan)
{
  const Receivers receivers = this->MayDim(frame, plan)
    ? GeometryReceiversOf(frame, this->resources, plan.viewport)
    : Receivers();
  if (receivers.empty())
  {
    this->Release(frame.view.window);
    return;
  }
  const Viewport pixels = PixelsOf(plan);
  const glm::dmat4 gridFromWorld = glm::inverse(frame.geometry.worldFromGrid);
  const std::vector<glm::vec4> places = PlacesOf(receivers, gridFromWorld, pixels);
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = CoverOf(frame.geometry.boxGrid, gridFromWorld, receivers);
  const std::vector<std::vector<float>> parts = plan.marcher == Marcher::Processor
    ? this->LightByPackets(frame, plan, places)
    : this->LightByShader(frame, plan, places, drawn.coverGrid);
  this->image.Take(frame.view.window, FactorsOf(frame, places.size(), receivers, parts), pixels);
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = pixels;
  this->boxes.Draw(frame, plan.WithRole(ShaderRole::DimGeometry), drawn, earlier);
}

void GeometryDimming::Release(vtkWindow* window)
{
  this->image.Release(window);
  this->light.Release(window);
}

}
