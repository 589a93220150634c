#include "Module/Scenes/UnevenGrid.h"

#include "Frame/PropertyTransferFunction.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

vtkSmartPointer<vtkDoubleArray> ArrayOf(const std::vector<double>& numbers)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (double number : numbers)
  {
    array->InsertNextValue(number);
  }
  return array;
}

std::vector<double> UnevenPlaces(int count, double extent, double power)
{
  std::vector<double> places;
  for (int i = 0; i < count; ++i)
  {
    places.push_back(extent * std::pow(double(i) / (count - 1), power));
  }
  return places;
}

namespace
{

// Smooth values from 0 to 1 by the number of the voxel.
double Wave(int x, int y, int z)
{
  return 0.5 + 0.25 * std::sin(0.7 * x + 0.3 * y) + 0.25 * std::cos(0.5 * y - 0.6 * z + 1.0);
}

}

vtkSmartPointer<vtkRectilinearGrid> WaveGrid(const Places& places)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const int counts[3] = { int(places[0].size()), int(places[1].size()), int(places[2].size()) };
  grid->SetDimensions(counts);
  grid->SetXCoordinates(ArrayOf(places[0]));
  grid->SetYCoordinates(ArrayOf(places[1]));
  grid->SetZCoordinates(ArrayOf(places[2]));
  vtkNew<vtkFloatArray> values;
  for (int i = 0; i < counts[0] * counts[1] * counts[2]; ++i)
  {
    values->InsertNextValue(
      float(Wave(i % counts[0], i / counts[0] % counts[1], i / counts[0] / counts[1])));
  }
  grid->GetPointData()->SetScalars(values);
  return grid;
}

vtkSmartPointer<vtkImageData> EvenImage(const Places& places)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(int(places[0].size()), int(places[1].size()), int(places[2].size()));
  image->SetOrigin(places[0].front(), places[1].front(), places[2].front());
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    spacing[axis] = (places[axis].back() - places[axis].front()) / double(places[axis].size() - 1);
  }
  image->SetSpacing(spacing);
  image->AllocateScalars(VTK_FLOAT, 1);
  return image;
}

namespace
{

// Interpolates between the coordinates, which it searches.
double WaveAt(const Places& places, glm::dvec3 position)
{
  int lower[3];
  double weight[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& all = places[axis];
    const auto upper = std::upper_bound(all.begin() + 1, all.end() - 1, position[axis]);
    lower[axis] = int(upper - all.begin()) - 1;
    weight[axis] = std::clamp(
      (position[axis] - all[lower[axis]]) / (all[lower[axis] + 1] - all[lower[axis]]), 0.0, 1.0);
  }
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double part =
      Wave(lower[0] + (corner & 1), lower[1] + (corner >> 1 & 1), lower[2] + (corner >> 2));
    for (int axis = 0; axis < 3; ++axis)
    {
      part *= corner >> axis & 1 ? weight[axis] : 1.0 - weight[axis];
    }
    value += part;
  }
  return value;
}

}

MapperScene::Material UnevenMaterial(MapperScene& scene, const Places& places)
{
  const TransferFunction function = TransferFunctionOf(scene.volume->GetProperty());
  return [&scene, places, function](glm::dvec3 positionGrid, const Ray&)
  {
    glm::dvec3 position;
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] =
        scene.image->GetOrigin()[axis] + positionGrid[axis] * scene.image->GetSpacing()[axis];
    }
    const double value = WaveAt(places, position);
    return OpticalProperties{ function.Color(value), function.Extinction(value) };
  };
}
