#ifndef Varimarch_Testing_DividedVolume_h
#define Varimarch_Testing_DividedVolume_h

#include "Core/Geometry/Box.h"
#include "Module/Scenes/MapperScene.h"
#include "Tolerance/SharedSearch.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

/// A volume of which several mappers draw a part each, as ParaView's processes do: each has the
/// cells of its part and two layers of voxels around them.
class DividedVolume
{
public:
  /// @param parts  the number of parts along each axis
  DividedVolume(MapperScene& scene, std::array<int, 3> parts);

  /// The images of all parts, laid over each other in floats.
  std::vector<float> Draw();

  /// The steps of the last drawing.
  const std::optional<varimarch::CommonSteps>& Steps() const { return this->steps; }

private:
  struct Part
  {
    varimarch::Box box; ///< in the coordinates of the data
    vtkNew<vtkVariationFieldVolumeMapper> mapper;
  };

  void AddPart(const std::array<int, 6>& extent);
  void TakeSettings(Part& part);
  std::vector<Part*> FrontToBack();

  MapperScene& scene;
  std::vector<std::unique_ptr<Part>> parts;
  varimarch::SharedSearch search;
  std::optional<varimarch::CommonSteps> steps;
};

#endif
