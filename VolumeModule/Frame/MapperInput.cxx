#include "Frame/MapperInput.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkType.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

// The scalars to draw. Throws std::runtime_error with what is wrong with the input.
vtkDataArray* CheckedScalars(vtkDataSet* data, vtkDataArray* scalars, int cellFlag)
{
  if (!scalars)
  {
    throw std::runtime_error("The input has no scalars to draw");
  }
  const std::string name = scalars->GetName() ? scalars->GetName() : "scalars";
  constexpr int fieldData = 2;
  if (cellFlag == fieldData)
  {
    throw std::runtime_error(
      "Array \"" + name + "\" holds field data: expected point or cell data");
  }
  if (scalars->GetDataType() == VTK_BIT)
  {
    throw std::runtime_error(
      "Array \"" + name + "\" holds single bits: expected numbers of at least 8 bits");
  }
  if (!scalars->HasStandardMemoryLayout())
  {
    throw std::runtime_error("Array \"" + name + "\" is a " + scalars->GetClassName() +
      ", which does not store the components of a voxel side by side: expected an array that does, "
      "such as a copy by vtkDataArray::DeepCopy");
  }
  const vtkIdType count = cellFlag == 0 ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  if (scalars->GetNumberOfTuples() != count)
  {
    throw std::runtime_error("Array \"" + name + "\" has " +
      std::to_string(scalars->GetNumberOfTuples()) + " values: expected one for each of " +
      std::to_string(count) + (cellFlag == 0 ? " points" : " cells"));
  }
  return scalars;
}

std::array<vtkDataArray*, 3> CoordinatesOf(vtkRectilinearGrid* grid)
{
  return { grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates() };
}

std::vector<double> NumbersOf(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    numbers.push_back(array->GetComponent(i, 0));
  }
  return numbers;
}

}

glm::ivec3 MapperInput::PointCount() const
{
  glm::ivec3 count(0);
  if (auto* image = vtkImageData::SafeDownCast(this->data))
  {
    image->GetDimensions(&count.x);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(this->data))
  {
    grid->GetDimensions(&count.x);
  }
  return count;
}

// A grid does not report changes of its coordinates.
vtkMTimeType MapperInput::Time() const
{
  vtkMTimeType time = std::max(this->data->GetMTime(), this->scalars->GetMTime());
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(this->data))
  {
    for (vtkDataArray* coordinates : CoordinatesOf(grid))
    {
      time = std::max(time, coordinates->GetMTime());
    }
  }
  return time;
}

VolumeGeometry MapperInput::Geometry(vtkVolume* volume, const std::vector<UnevenAxis>& axes) const
{
  return axes.empty()
    ? VolumeGeometryOf(vtkImageData::SafeDownCast(this->data), volume, this->place)
    : VolumeGeometryOf(axes, volume);
}

std::vector<UnevenAxis> MapperInput::Axes(bool nearest) const
{
  std::vector<UnevenAxis> axes;
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(this->data))
  {
    for (vtkDataArray* coordinates : CoordinatesOf(grid))
    {
      axes.emplace_back(NumbersOf(coordinates), this->place == VoxelPlace::Cells, nearest);
    }
  }
  return axes;
}

MapperInput InputOf(vtkImageData* image)
{
  return { image, image->GetPointData()->GetScalars(), VoxelPlace::Points };
}

std::optional<MapperInput> InputOf(vtkVolumeMapper* mapper, int port)
{
  auto* const data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(port, 0));
  if (!vtkImageData::SafeDownCast(data) && !vtkRectilinearGrid::SafeDownCast(data))
  {
    throw std::runtime_error("The input is neither vtkImageData nor vtkRectilinearGrid");
  }
  if (data->GetNumberOfPoints() == 0)
  {
    return std::nullopt;
  }
  int cellFlag = 0;
  vtkDataArray* scalars = vtkAbstractVolumeMapper::GetScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  return MapperInput{ data, CheckedScalars(data, scalars, cellFlag),
    cellFlag == 0 ? VoxelPlace::Points : VoxelPlace::Cells };
}

}
