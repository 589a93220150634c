// The resources and uniforms of voxels at uneven places.

#include "RayMarcher.h"

#include "vtkOpenGLRenderWindow.h"

namespace varimarch
{

void RayMarcher::UpdateSpacing(const Frame& frame)
{
  if (!frame.settings.uneven)
  {
    this->spacing.Release(frame.window);
    this->spacingBins.clear();
    return;
  }
  std::vector<glm::vec4> bins;
  for (const UnevenAxis& axis : frame.axes)
  {
    const std::vector<glm::vec4> ofAxis = axis.Bins();
    bins.insert(bins.end(), ofAxis.begin(), ofAxis.end());
  }
  if (bins != this->spacingBins)
  {
    this->spacing.Upload(frame.window, bins);
    this->spacingBins = bins;
  }
}

void RayMarcher::SetSpacingUniforms(const Frame& frame)
{
  glm::dvec3 firstBins;
  glm::dvec3 lastBins;
  glm::dvec3 lowerGrid;
  glm::dvec3 binsPerGrid;
  double firstBin = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const UnevenAxis& uneven = frame.axes[axis];
    const double count = double(uneven.Bins().size());
    firstBins[axis] = firstBin;
    lastBins[axis] = firstBin + count - 1.0;
    lowerGrid[axis] = uneven.LowerGrid();
    binsPerGrid[axis] = count / (uneven.UpperGrid() - uneven.LowerGrid());
    firstBin += count;
  }
  this->spacing.Texture()->Activate();
  this->program.Set("spacingTable", this->spacing.Texture());
  this->program.Set("spacingFirstBins", firstBins);
  this->program.Set("spacingLastBins", lastBins);
  this->program.Set("spacingLowerGrid", lowerGrid);
  this->program.Set("spacingBinsPerGrid", binsPerGrid);
  this->program.Set("spacingVoxelCount", glm::dvec3(frame.geometry.dimensions));
}

}
