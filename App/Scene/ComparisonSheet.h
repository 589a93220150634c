#ifndef Varimarch_Scene_ComparisonSheet_h
#define Varimarch_Scene_ComparisonSheet_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace varimarch
{

/// One renderer's column of a comparison sheet. All images of a sheet have the same size.
struct SheetColumn
{
  std::string title;
  std::string subtitle;
  vtkSmartPointer<vtkImageData> picture;    ///< byte image
  vtkSmartPointer<vtkImageData> difference; ///< see DifferencePicture.h; null for the reference
};

/// Draws the columns side by side: titles, rendered images, and below them the difference images.
/// The colour scale of the differences stands below the reference.
vtkSmartPointer<vtkImageData> ComparisonSheet(const std::vector<SheetColumn>& columns);

}

#endif
