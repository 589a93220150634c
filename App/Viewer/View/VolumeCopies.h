#ifndef Varimarch_Viewer_VolumeCopies_h
#define Varimarch_Viewer_VolumeCopies_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace varimarch
{

struct LoadedVolume;

/// Copies of volumes for another thread, which share their voxels. A volume has one copy for as
/// long as somebody else holds it: whoever draws a time again that was played before knows it by
/// the copy.
class VolumeCopies
{
public:
  vtkSmartPointer<vtkImageData> Of(const LoadedVolume& volume);

private:
  struct Copy
  {
    vtkSmartPointer<vtkImageData> source;
    vtkSmartPointer<vtkImageData> copy;
  };

  void ForgetReleased();

  std::vector<Copy> copies;
};

}

#endif
