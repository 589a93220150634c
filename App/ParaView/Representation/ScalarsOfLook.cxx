#include "ScalarsOfLook.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>
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

vtkSmartPointer<vtkDataArray> MappedScalars(vtkDataArray* vectors, vtkScalarsToColors* look)
{
  return look->GetVectorMode() == vtkScalarsToColors::MAGNITUDE
    ? Magnitudes(vectors)
    : Component(vectors, look->GetVectorComponent());
}

}

void ScalarsOfLook::Choose(vtkDataSet* given, vtkVolumeMapper* chooser, vtkVolumeProperty* property)
{
  int cellFlag = 0;
  vtkDataArray* const array = vtkAbstractVolumeMapper::GetScalars(given, chooser->GetScalarMode(),
    chooser->GetArrayAccessMode(), chooser->GetArrayId(), chooser->GetArrayName(), cellFlag);
  if (!array || array->GetNumberOfComponents() == 1 || !property->GetIndependentComponents())
  {
    *this = ScalarsOfLook();
    this->data = given;
    return;
  }
  vtkColorTransferFunction* const look = property->GetRGBTransferFunction(0);
  std::ostringstream key;
  key << given << " " << given->GetMTime() << " " << array << " " << array->GetMTime() << " "
      << look->GetVectorMode() << " " << look->GetVectorComponent();
  if (this->source == key.str())
  {
    return;
  }
  this->source = key.str();
  this->name = std::string(array->GetName() ? array->GetName() : "scalars") + " of a vector";
  vtkSmartPointer<vtkDataArray> scalars = MappedScalars(array, look);
  scalars->SetName(this->name.c_str());
  this->data.TakeReference(given->NewInstance());
  this->data->ShallowCopy(given);
  this->data->GetAttributes(cellFlag == 0 ? vtkDataObject::POINT : vtkDataObject::CELL)
    ->AddArray(scalars);
}

}
