#ifndef Varimarch_ScalarsOfLook_h
#define Varimarch_ScalarsOfLook_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataSet;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace varimarch
{

/// The scalars of a data set that a transfer function of one component maps. Of an array of vectors
/// they are the magnitude or a component, as the vector mode of the property's colours says, and
/// are kept until these or the vectors change.
class ScalarsOfLook
{
public:
  /// Chooses the scalars among those of a data set. `chooser` has the scalar mode and the name or
  /// the number of the array.
  void Choose(vtkDataSet* data, vtkVolumeMapper* chooser, vtkVolumeProperty* property);

  /// The data set, or a copy that shares its arrays and has another of scalars.
  vtkDataSet* Data() const { return this->data; }

  /// The name of the added array; empty if Data() is the data set itself.
  const std::string& Name() const { return this->name; }

private:
  vtkSmartPointer<vtkDataSet> data;
  std::string name;
  std::string source; // the data set, array and look that the added array was made from
};

}

#endif
