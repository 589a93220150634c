#include "ScalarsOfLook.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkScalarsToColors.h"

#include <algorithm>
#include <vector>

namespace varimarch
{

namespace
{

vtkSmartPointer<vtkDataArray> Magnitudes(vtkDataArray* vectors)
{
  auto magnitudes = vtkSmartPointer<vtkFloatArray>::New();
  magnitudes->SetNumberOfTuples(vectors->GetNumberOfTuples());
  vtkSMPTools::For(0, vectors->GetNumberOfTuples(),
    [&](vtkIdType begin, vtkIdType end)
    {
      const int count = vectors->GetNumberOfComponents();
      std::vector<double> vector(count);
      for (vtkIdType i = begin; i < end; ++i)
      {
        vectors->GetTuple(i, vector.data());
        double squared = 0.0;
        std::for_each(vector.begin(), vector.end(), [&](double x) { squared += x * x; });
        magnitudes->SetValue(i, static_cast<float>(std::sqrt(squared)));
      }
    });
  return magnitudes;
}

vtkSmartPointer<vtkDataArray> Component(vtkDataArray* vectors, int component)
{
  vtkSmartPointer<vtkDataArray> scalars;
  scalars.TakeReference(vectors->NewInstance());
  scalars->SetNumberOfTuples(vectors->GetNumberOfTuples());
  scalars->CopyComponent(
    0, vectors, std::min(std::max(component, 0), vectors->GetNumberOfComponents() - 1));
  return scalars;
}

}

vtkSmartPointer<vtkDataArray> ScalarsOfLook(vtkDataArray* vectors, vtkScalarsToColors* look)
{
  return look->GetVectorMode() == vtkScalarsToColors::MAGNITUDE
    ? Magnitudes(vectors)
    : Component(vectors, look->GetVectorComponent());
}

}
