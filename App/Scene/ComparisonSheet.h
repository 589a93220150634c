#ifndef Varimarch_Scene_ComparisonSheet_h
#define Varimarch_Scene_ComparisonSheet_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

/// One renderer's part of a comparison sheet. All pictures of a sheet have one size.
struct SheetColumn
{
  std::string title;
  std::string subtitle;
  vtkSmartPointer<vtkImageData> picture;    ///< byte picture
  vtkSmartPointer<vtkImageData> difference; ///< see DifferencePicture.h; null for the truth itself
};

/// The columns side by side as a byte picture: titles, pictures, and below them the differences,
/// with their scale below the truth.
vtkSmartPointer<vtkImageData> ComparisonSheet(const std::vector<SheetColumn>& columns);

}

#endif
