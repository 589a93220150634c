#ifndef Varimarch_Viewer_ImageCopies_h
#define Varimarch_Viewer_ImageCopies_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

namespace varimarch
{

/// Copies of images for another thread, each made once for each version and kept as long as it is
/// asked for: whoever draws a copy knows by its address that nothing has changed.
class ImageCopies
{
public:
  using Make = std::function<vtkSmartPointer<vtkImageData>()>;

  /// From Begin() to End(), copies are asked for. Those that are not are forgotten then.
  void Begin();
  void End();

  /// @param make  makes a copy if there is none of this version
  vtkSmartPointer<vtkImageData> Of(vtkImageData* source, int version, const Make& make);

private:
  struct Copy
  {
    vtkSmartPointer<vtkImageData> source; ///< kept, so that no other image has its address
    int version;
    vtkSmartPointer<vtkImageData> copy;
  };

  std::vector<Copy> before;
  std::vector<Copy> used;
};

}

#endif
