#include "FeatureInputs.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace varimarch
{

namespace
{

vtkDataArray* ScalarsOf(vtkImageData* image)
{
  return image->GetPointData()->GetScalars();
}

vtkSmartPointer<vtkImageData> SameGrid(vtkImageData* image)
{
  const auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->CopyStructure(image);
  return copy;
}

// Calls a function for each point of a ball about the centre, whose radius is a quarter of the
// volume's side.
template <class OnPoint>
void ForPointsInBall(vtkImageData* image, const OnPoint& onPoint)
{
  const int* size = image->GetDimensions();
  vtkIdType point = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x, ++point)
      {
        const double offset = std::hypot(
          double(x) / size[0] - 0.5, double(y) / size[1] - 0.5, double(z) / size[2] - 0.5);
        if (offset < 0.25)
        {
          onPoint(point);
        }
      }
    }
  }
}

}

vtkSmartPointer<vtkImageData> WithTwoComponents(vtkImageData* image)
{
  vtkDataArray* scalars = ScalarsOf(image);
  const auto pairs = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(scalars->GetNumberOfTuples());
  pairs->CopyComponent(0, scalars, 0);
  pairs->CopyComponent(1, scalars, 0);
  const auto copy = SameGrid(image);
  copy->GetPointData()->SetScalars(pairs);
  return copy;
}

vtkSmartPointer<vtkImageData> WithFourColors(vtkImageData* image)
{
  vtkDataArray* scalars = ScalarsOf(image);
  const double* range = scalars->GetRange();
  const double bytesPerScalar = 255.0 / std::max(range[1] - range[0], 1e-30);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const auto byte =
      static_cast<unsigned char>((scalars->GetComponent(i, 0) - range[0]) * bytesPerScalar);
    const unsigned char color[4] = { byte, byte, byte, byte };
    colors->SetTypedTuple(i, color);
  }
  const auto copy = SameGrid(image);
  copy->GetPointData()->SetScalars(colors);
  return copy;
}

vtkSmartPointer<vtkDataSet> OnCells(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    ++extent[2 * axis + 1];
  }
  const auto copy = SameGrid(image);
  copy->SetExtent(extent);
  copy->GetCellData()->SetScalars(ScalarsOf(image));
  return copy;
}

vtkSmartPointer<vtkDataSet> OnRectilinearGrid(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  grid->SetExtent(image->GetExtent());
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = image->GetExtent()[2 * axis];
    for (int i = 0; i < image->GetDimensions()[axis]; ++i)
    {
      coordinates[axis]->InsertNextValue(
        image->GetOrigin()[axis] + (first + i) * image->GetSpacing()[axis]);
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  grid->GetPointData()->SetScalars(ScalarsOf(image));
  return grid;
}

vtkSmartPointer<vtkDataSet> WithBlankedBall(vtkImageData* image)
{
  const auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->CopyStructure(image);
  grid->GetPointData()->SetScalars(ScalarsOf(image));
  ForPointsInBall(image, [&](vtkIdType point) { grid->BlankPoint(point); });
  return grid;
}

vtkSmartPointer<vtkImageData> BallMask(vtkImageData* image)
{
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfTuples(image->GetNumberOfPoints());
  labels->Fill(0.0);
  ForPointsInBall(image, [&](vtkIdType point) { labels->SetValue(point, 255); });
  const auto mask = SameGrid(image);
  mask->GetPointData()->SetScalars(labels);
  return mask;
}

vtkSmartPointer<vtkImageData> OpacityOfScalarAndGradient()
{
  constexpr int Side = 256;
  const auto table = vtkSmartPointer<vtkImageData>::New();
  table->SetDimensions(Side, Side, 1);
  table->AllocateScalars(VTK_FLOAT, 4);
  for (int gradient = 0; gradient < Side; ++gradient)
  {
    for (int scalar = 0; scalar < Side; ++scalar)
    {
      auto* entry = static_cast<float*>(table->GetScalarPointer(scalar, gradient, 0));
      const float part = float(scalar) / float(Side - 1);
      entry[0] = 1.0f;
      entry[1] = part;
      entry[2] = 0.5f * part;
      entry[3] = part < 0.3f ? 0.0f : 0.2f * part * float(gradient + 16) / float(Side + 15);
    }
  }
  return table;
}

}
